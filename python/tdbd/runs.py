"""The commands run and rotate."""

import os
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from tdbd import _core
from tdbd.arguments import assignments
from tdbd.cases import Case, of_kind
from tdbd.errors import CaseWarning, in_python_words
from tdbd.results import RotationResult, RunResult, load
from tdbd.scratch import folder_for

Folder = str | os.PathLike[str]
Progress = Callable[[int, int], object]


def _warn(told: list[str]) -> None:
    for text in told:
        warnings.warn(in_python_words(text), CaseWarning, stacklevel=3)


def run(case: Case | Folder, folder: Folder | None = None, *, force: bool = False, threads: int = 1,
        progress: Progress | None = None) -> RunResult:
    """Drills a case, like `tdbd run`. Without `folder`, the files are deleted with the result.

    `force` replaces results in the folder. `progress(done, total)` is called ten times per second.
    The result does not depend on `threads`. Ctrl-C raises KeyboardInterrupt after the current step;
    everything recorded is in the folder, and `tdbd.resume` continues the run. Raises FolderError
    before anything is changed, RunError if the computation fails.
    """
    drilled = of_kind(case, "drilling")
    path, keep = folder_for(folder)
    _warn(_core.run(drilled.checked, path, force, threads, progress))
    return RunResult(path, keep)


def rotate(case: Case | Folder, folder: Folder | None = None, *, force: bool = False,
           progress: Progress | None = None) -> RotationResult:
    """Integrates the rotation of a body, like `tdbd rotate`. Arguments as for `run`."""
    rotated = of_kind(case, "rotation")
    path, keep = folder_for(folder)
    _warn(_core.rotate(rotated.checked, path, force, progress))
    return RotationResult(path, keep)


def resume(folder: Folder, set: Mapping[str, Any] | None = None, *, threads: int = 1, progress: Progress | None = None,
           **keys: Any) -> RunResult | RotationResult:
    """Resumes an interrupted run or rotation. The result is bitwise identical to that of an uninterrupted one.

    A complete result is returned unchanged, unless a later end is given: `time__duration="20 s"`, or of a
    run `time__revolutions=20` or `output__means_from="5 s"`. These are written as in `tdbd.case`. A complete
    run continues from its last checkpoint, a complete rotation is computed again from its start.
    """
    path, changes = os.fspath(folder), assignments(set, keys)
    if not _core.tidy_if_finished(path) or changes:
        if _core.kind_of(str(Path(path) / "case.toml"), []) == "rotation":
            _warn(_core.resume_rotate(path, changes, progress))
        else:
            _warn(_core.resume_run(path, changes, threads, progress))
    return load(path)
