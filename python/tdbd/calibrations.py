"""The commands calibrate and laboratory."""

import csv
import functools
import json
import os
import re
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tdbd import _core
from tdbd.cases import Case, of_kind
from tdbd.errors import CaseWarning, in_python_words
from tdbd.runs import Folder, Progress
from tdbd.scratch import Scratch, folder_for, place_in, reopened

if TYPE_CHECKING:
    import xarray

_HEAD = re.compile(r"(?P<name>.+?) \[(?P<unit>.*)\]")


def _column(name: str, texts: list[str]) -> tuple[str, tuple[str, list[Any], dict[str, str]]]:
    """Returns a column of numbers if its head has a unit, otherwise of texts. An empty number becomes NaN."""
    head = _HEAD.fullmatch(name)
    if not head:
        return name, ("record", texts, {})
    return head["name"], ("record", [float(text) if text else float("nan") for text in texts], {"units": head["unit"]})


def read_table(path: Folder) -> "xarray.Dataset":
    """Reads a csv with units in its head as a Dataset with the dimension record."""
    import xarray

    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    return xarray.Dataset(dict(_column(name, [row[i] for row in rows]) for i, name in enumerate(head)))


class CalibrationResult:
    """The result of `tdbd.calibrate`. Each file is read once, when it is first used."""

    folder: Path

    def __init__(self, folder: Folder, keep: Scratch | None = None, answer: str = "") -> None:
        self.folder = Path(folder).absolute()
        self._keep = keep
        self.answer = answer  #: as printed in a terminal; "" for a folder of an earlier calibration

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the files of a temporary folder; of another folder the path."""
        return _again, (place_in(self.folder, self._keep), self._keep, self.answer)

    def __repr__(self) -> str:
        state = {True: "the law fits", False: "THE LAW DOES NOT FIT", None: "not tested"}[self.fits]
        return f"<tdbd.CalibrationResult of {self.data['law']}: {state}, in {self.folder}>"

    @functools.cached_property
    def data(self) -> dict[str, Any]:
        """calibration.json: coefficients with intervals, objectives, errors of fitted and withheld bits."""
        return json.loads((self.folder / "calibration.json").read_text(encoding="utf-8"))

    @property
    def fits(self) -> bool | None:
        """Whether the law fits the readings; None without degrees of freedom. `data["fit_test"]` has the p value."""
        return self.data["fits"]

    @property
    def worst_readings(self) -> list[dict[str, Any]]:
        """The fitted readings that are more than two standard deviations away, at most five; the worst first."""
        return [one for found in self.data.get("by_pressure", [self.data]) for one in found["worst_readings"]]

    @property
    def coefficients(self) -> dict[str, dict[str, Any]]:
        """For all pressures together: "value", "se", "low", "high", "start", "unit" and more of each coefficient."""
        return self.data["coefficients"]

    @functools.cached_property
    def residuals(self) -> "xarray.Dataset":
        """The fitted records, with mean, standard error, interval and reading of each load; dimension record."""
        return read_table(self.folder / "residuals.csv")

    @functools.cached_property
    def predictions(self) -> "xarray.Dataset":
        """The same for the records that are predicted rather than fitted."""
        return read_table(self.folder / "predictions.csv")

    @functools.cached_property
    def law(self) -> str:
        """law.toml: a table [forces] for a case. After separate fits, there is one file for each pressure."""
        return (self.folder / "law.toml").read_text(encoding="utf-8")


def _again(place: str, keep: Scratch | None, answer: str) -> CalibrationResult:
    """Returns a pickled result."""
    return CalibrationResult(reopened(place, keep), keep, answer)


def calibrate(case: Case | Folder, folder: Folder | None = None, *, cuts: Folder | None = None, force: bool = False,
              threads: int = 1, progress: Progress | None = None) -> CalibrationResult:
    """Fits a force law to records, like `tdbd calibrate`. Without a folder, the files are deleted with the result.

    `cuts`: folder in which cut runs are stored and reused; the default is beside the results.
    `progress(done, total)` is called after each cut run. Ctrl-C takes effect after the current cut
    run. A law that does not fit the readings produces a CaseWarning.
    """
    found = of_kind(case, "calibration")
    path, keep = folder_for(folder)
    place = "" if cuts is None else os.fspath(cuts)
    answer, told = _core.calibrate(found.checked, path, place, force, threads, progress)
    for text in told:
        warnings.warn(in_python_words(text), CaseWarning, stacklevel=2)
    return CalibrationResult(path, keep, answer)


def laboratory(case: Case | Folder, file: Folder, *, cuts: Folder | None = None, force: bool = False, threads: int = 1,
               progress: Progress | None = None) -> "xarray.Dataset":
    """Writes synthetic records under a known law to a csv file and returns them, like `tdbd laboratory`."""
    found = of_kind(case, "laboratory")
    path = os.fspath(file)
    _core.laboratory(found.checked, path, "" if cuts is None else os.fspath(cuts), force, threads, progress)
    return read_table(path)
