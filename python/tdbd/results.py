"""Result folders, as run and rotate leave them."""

import functools
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tdbd import _core, plots
from tdbd.scratch import Scratch
from tdbd.surfaces import Surface

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure


class Result:
    """A result folder. Each file is read once, when it is first used."""

    folder: Path  #: where the files are; of a run without a folder a temporary one, which goes with the result

    def __init__(self, folder: str | os.PathLike[str], keep: Scratch | None = None) -> None:
        self.folder = Path(folder).absolute()
        self._keep = keep

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self.summary['title'] or 'a case'}, {self.summary['status']}, in {self.folder}>"

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The figures: summary.json, units in the names of keys."""
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def timing(self) -> dict[str, Any]:
        """Seconds, memory and threads: timing.json."""
        return json.loads((self.folder / "timing.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def history(self) -> "xarray.Dataset":
        """history.nc in memory: dimension time, and part, cutter, cone, xyz where there are any; `units`, `long_name`."""
        try:
            import xarray
        except ImportError as error:
            raise ImportError("history: found no xarray, expected it (Debian: python3-xarray, python3-netcdf4)") from error
        with _core.FilesLock():
            return xarray.load_dataset(self.folder / "history.nc", engine="netcdf4", decode_times=False)


class RunResult(Result):
    """What `tdbd.run` leaves."""

    @functools.cached_property
    def rock(self) -> Surface:
        """The rock's surface at the end: rock_final.ply."""
        return Surface(*_core.read_surface(str(self.folder / "rock_final.ply")))

    def plot(self) -> "Figure":
        """The bottom hole from above, depth in colour, and what the bit removed over its turns."""
        return plots.bottom_hole(self.rock, self.history, self.summary["title"])


class RotationResult(Result):
    """What `tdbd.rotate` leaves."""

    def plot(self) -> "Figure":
        """The path of the body's third axis, and the drift of the energy."""
        return plots.axis_path(self.history, self.summary)


def load(folder: str | os.PathLike[str]) -> RunResult | RotationResult:
    """A result that lies in a folder."""
    result = Result(folder)
    return RotationResult(folder) if result.summary["command"] == "rotate" else RunResult(folder)
