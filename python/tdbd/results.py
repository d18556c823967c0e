"""Result folders of run and rotate."""

import functools
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tdbd import _core, plots
from tdbd.scratch import Scratch, place_in, reopened
from tdbd.surfaces import Surface

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure


class Result:
    """A result folder. Each file is read once, when it is first used.

    A result can be pickled, so that a process of multiprocessing can return it. The files of a temporary
    folder travel with it; of another folder only the path does.
    """

    folder: Path  #: contains the files; for a run without a folder temporary, and deleted with the result

    def __init__(self, folder: str | os.PathLike[str], keep: Scratch | None = None) -> None:
        self.folder = Path(folder).absolute()
        self._keep = keep

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (type(self), place_in(self.folder, self._keep), self._keep)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {self.summary['title'] or 'a case'}, {self.summary['status']}, in {self.folder}>"

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The contents of summary.json. The names of keys contain the units."""
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def timing(self) -> dict[str, Any]:
        """The contents of timing.json: seconds, memory and threads."""
        return json.loads((self.folder / "timing.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def history(self) -> "xarray.Dataset":
        """history.nc in memory, with `units` and `long_name`. Dimensions: time and, if any, part, cutter, cone, xyz.

        Names label the dimensions: `history.sel(part="cutter-1/face")`, `history.sel(cutter="cutter-1")`.
        """
        try:
            import xarray
        except ImportError as error:
            raise ImportError("history: found no xarray, expected it (Debian: python3-xarray, python3-netcdf4)") from error
        with _core.FilesLock():
            loaded = xarray.load_dataset(self.folder / "history.nc", engine="netcdf4", decode_times=False)
        labels = {name: loaded[f"{name}_name"].values for name in loaded.dims if f"{name}_name" in loaded}
        return loaded.assign_coords(labels)


def _again(kind: type[Result], place: str, keep: Scratch | None) -> Result:
    """Returns a pickled result."""
    return kind(reopened(place, keep), keep)


class RunResult(Result):
    """The result of `tdbd.run`."""

    @functools.cached_property
    def rock(self) -> Surface:
        """The final surface of the rock: rock_final.ply."""
        return Surface(*_core.read_surface(str(self.folder / "rock_final.ply")))

    def plot(self) -> "Figure":
        """Plots the hole from above, coloured by depth, and the removed rock over revolutions."""
        return plots.bottom_hole(self.rock, self.history, self.summary)


class RotationResult(Result):
    """The result of `tdbd.rotate`."""

    def plot(self) -> "Figure":
        """Plots the path of the body's third axis and the drift of the energy."""
        return plots.axis_path(self.history, self.summary)


def load(folder: str | os.PathLike[str]) -> RunResult | RotationResult:
    """Returns the result of run or rotate in a folder.

    Raises FileNotFoundError if it is no such folder; the message names the function that reads the table of a sweep.
    """
    result = Result(folder)
    if not (result.folder / "summary.json").is_file():
        table = "; for the table of a sweep: tdbd.sweep.load" if result.folder.suffix == ".nc" else ""
        raise FileNotFoundError(f"{result.folder}: found no folder with summary.json, expected a result of run or rotate{table}")
    return RotationResult(folder) if result.summary["command"] == "rotate" else RunResult(folder)
