"""Sweeps: run a design of many cases and return one table.

    result = tdbd.sweep.run("cases/sweeps/rake-and-rate.toml", "out/rake.nc", threads=2)
    result.data["wob_mean_n"], result.records[0]
"""

import functools
import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from tdbd import _core
from tdbd.errors import CaseWarning, FolderError, RunError, in_python_words
from tdbd.scratch import Scratch, place_in, reopened

if TYPE_CHECKING:
    import xarray

_STATUS = ("done", "failed", "missing", "left out")


@dataclass(frozen=True)
class SweepResult:
    """The table of a sweep. Returned by `tdbd.sweep.run` and `tdbd.sweep.load`."""

    table: Path  #: NAME.nc; NAME.csv contains the same
    points: int  #: that are run
    done: int  #: completed, successful or failed
    found: int = 0  #: of this shard, completed by an earlier call
    failed: int = 0
    _keep: Scratch | None = field(default=None, repr=False)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the files of a temporary folder; of another table the path."""
        counts = (self.points, self.done, self.found, self.failed)
        return _again, (place_in(self.table, self._keep), counts, self._keep)

    def __repr__(self) -> str:
        counts = f"{self.done} of {self.points} points done, {self.failed} failed"
        return f"<tdbd.sweep.SweepResult: {counts}, in {self.table}>"

    @property
    def complete(self) -> bool:
        """Whether all points are completed, so that the table exists."""
        return self.done == self.points

    @functools.cached_property
    def data(self) -> "xarray.Dataset":
        """The table: dimension point, factors under their keys, figures, status, front, message. Figures are SI."""
        if not self.complete:
            raise RunError(f"{self.table}: {self.done} of {self.points} points are done; "
                           "the last shard writes the table")
        import xarray

        with _core.FilesLock():
            return xarray.load_dataset(self.table, engine="netcdf4", decode_times=False)

    @property
    def records(self) -> list[dict[str, Any]]:
        """The table as one dictionary per point; the status is a text."""
        columns = {name: values.values.tolist() for name, values in self.data.items()}
        columns["status"] = [_STATUS[int(status)] for status in columns["status"]]
        return [dict(zip(columns, row)) for row in zip(*columns.values())]


def _again(place: str, counts: tuple[int, int, int, int], keep: Scratch | None) -> SweepResult:
    """Returns a pickled result. The table exists only if all points are done."""
    path = reopened(place, keep) if counts[0] == counts[1] else Path(place)
    return SweepResult(path, *counts, keep)


def _design(path: str | os.PathLike[str]) -> str:
    name = os.fspath(path)
    _core.require_kind(name, [], ["sweep"])
    return name


def _table(table: str | os.PathLike[str], force: bool) -> str:
    """Checks that a sweep may write this table."""
    path = Path(table)
    if path.suffix != ".nc":
        raise ValueError(f"table: found {path}, expected a file NAME.nc")
    if path.exists() and not path.with_suffix(".points").is_dir() and not force:
        raise FolderError(f"{path}: exists and was not written by a sweep; force=True replaces it")
    return str(path)


def run(design: str | os.PathLike[str], table: str | os.PathLike[str] | None = None, *, threads: int = 1,
        shard: tuple[int, int] = (1, 1), force: bool = False,
        progress: Callable[[int, int], object] | None = None) -> SweepResult:
    """Runs the points of a design, like `tdbd sweep`, several at a time on `threads` threads.

    Completed points are kept beside the table: after Ctrl-C the same call continues, and a larger design
    reuses them. Without `table`, files are deleted with the result. `shard=(i, n)` runs every n-th
    point from the i-th. A point that fails is in the table with its message, and CaseWarning reports it.
    """
    found = _design(design)
    keep = Scratch() if table is None else None
    path = str(keep.path / "sweep.nc") if table is None else _table(table, force)
    i, n = shard
    if not 1 <= i <= n:
        raise ValueError(f"shard: found {i} of {n}, expected (i, n) with 1 <= i <= n")
    done = _core.run_sweep(found, path, (i, n), threads, progress)
    if done["failed"]:
        text = f"{done['failed']} of {done['done']} points failed, the first with: {done['first_failure']}"
        warnings.warn(in_python_words(text), CaseWarning, stacklevel=2)
    return SweepResult(Path(path).absolute(), done["points"], done["done"], done["found"], done["failed"], keep)


def load(table: str | os.PathLike[str]) -> SweepResult:
    """Returns the table of an earlier sweep."""
    path = Path(table).absolute()
    if not path.is_file():
        raise FileNotFoundError(f"{path}: found no table of a sweep")
    result = SweepResult(path, 0, 0)
    status = np.asarray(result.data["status"])
    run_points = int(np.sum(status != 3))
    return SweepResult(path, run_points, run_points, 0, int(np.sum(status == 1)))


def points(design: str | os.PathLike[str]) -> list[dict[str, str]]:
    """Returns the settings of every point, by key, and runs nothing."""
    return [dict(setting.split("=", 1) for setting in point) for point in _core.sweep_points(_design(design))]


def figures(design: str | os.PathLike[str]) -> list[str]:
    """Runs the first point and returns the names of all numbers that the design may list as figures."""
    keep = Scratch()
    return _core.sweep_figures(_design(design), str(keep.path / "cuts"))
