"""The commands calibrate and laboratory."""

import csv
import functools
import json
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tdbd import _core
from tdbd.cases import Case, of_kind
from tdbd.runs import Folder, Progress
from tdbd.scratch import Scratch, folder_for

if TYPE_CHECKING:
    import xarray

_HEAD = re.compile(r"(?P<name>.+?) \[(?P<unit>.*)\]")


def _column(name: str, texts: list[str]) -> tuple[str, tuple[str, list[Any], dict[str, str]]]:
    """A column of numbers where its head has a unit, otherwise of texts; an empty number is none."""
    head = _HEAD.fullmatch(name)
    if not head:
        return name, ("record", texts, {})
    return head["name"], ("record", [float(text) if text else float("nan") for text in texts], {"units": head["unit"]})


def read_table(path: Folder) -> "xarray.Dataset":
    """A csv with units in its head, as a Dataset with the dimension record."""
    import xarray

    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    return xarray.Dataset(dict(_column(name, [row[i] for row in rows]) for i, name in enumerate(head)))


class CalibrationResult:
    """The result of `tdbd.calibrate`. Each file is read once, when it is first used."""

    folder: Path

    def __init__(self, folder: Folder, keep: Scratch | None = None) -> None:
        self.folder = Path(folder).absolute()
        self._keep = keep

    @functools.cached_property
    def data(self) -> dict[str, Any]:
        """calibration.json: coefficients with intervals, objectives, errors of fitted and withheld bits."""
        return json.loads((self.folder / "calibration.json").read_text(encoding="utf-8"))

    @property
    def coefficients(self) -> dict[str, dict[str, Any]]:
        """Of a fit of all pressures together: for each coefficient "value", "se", "low", "high", "start", "unit" and more."""
        return self.data["coefficients"]

    @functools.cached_property
    def residuals(self) -> "xarray.Dataset":
        """The fitted records, with mean, standard error, interval and reading of each load; dimension record."""
        return read_table(self.folder / "residuals.csv")

    @functools.cached_property
    def predictions(self) -> "xarray.Dataset":
        """The same of the records that the fit did not see."""
        return read_table(self.folder / "predictions.csv")

    @functools.cached_property
    def law(self) -> str:
        """law.toml: a table [forces] for a case. Of separate pressures the folder has one for each."""
        return (self.folder / "law.toml").read_text(encoding="utf-8")


def calibrate(case: Case | Folder, folder: Folder | None = None, *, cuts: Folder | None = None, force: bool = False,
              threads: int = 1, progress: Progress | None = None) -> CalibrationResult:
    """Fits a force law to measured records: `tdbd calibrate`. Without a folder the files go with the result.

    `cuts`: where cut runs are kept and found again; without it beside the results. `progress(done, total)` hears of cut
    runs. Ctrl-C is looked at after each of them.
    """
    found = of_kind(case, "calibration")
    path, keep = folder_for(folder)
    _core.calibrate(found.checked, path, "" if cuts is None else os.fspath(cuts), force, threads, progress)
    return CalibrationResult(path, keep)


def laboratory(case: Case | Folder, file: Folder, *, cuts: Folder | None = None, force: bool = False, threads: int = 1,
               progress: Progress | None = None) -> "xarray.Dataset":
    """Writes synthetic records under a known law into a csv file, and returns them: `tdbd laboratory`."""
    found = of_kind(case, "laboratory")
    path = os.fspath(file)
    _core.laboratory(found.checked, path, "" if cuts is None else os.fspath(cuts), force, threads, progress)
    return read_table(path)
