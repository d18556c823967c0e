"""Temporary folders that are deleted with the object that uses them, and travel with it to other processes."""

import os
import shutil
import tempfile
import weakref
from pathlib import Path


def _delete(path: Path, owner: int) -> None:
    """Deletes the folder, unless this is a fork of the process that created it."""
    if os.getpid() == owner:
        shutil.rmtree(path, ignore_errors=True)


class Scratch:
    """A temporary folder. It is deleted with this object, or at the latest when Python exits.

    A fork of the process does not delete it. Pickling includes its files: the copy in another process
    has a folder of its own.
    """

    def __init__(self) -> None:
        self.path = Path(tempfile.mkdtemp(prefix="tdbd-"))
        weakref.finalize(self, _delete, self.path, os.getpid())

    def __reduce__(self) -> tuple[object, ...]:
        if not self.path.is_dir():
            raise FileNotFoundError(f"{self.path}: found no folder, expected the files of a result")
        files = [path for path in sorted(self.path.rglob("*")) if path.is_file()]
        return _unpacked, ([(path.relative_to(self.path).as_posix(), path.read_bytes()) for path in files],)

    def __copy__(self) -> "Scratch":
        return self

    def __deepcopy__(self, memo: object) -> "Scratch":
        return self  # the files do not change


def _unpacked(files: list[tuple[str, bytes]]) -> Scratch:
    """Returns a temporary folder with these files."""
    keep = Scratch()
    for name, contents in files:
        path = keep.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(contents)
    return keep


def place_in(path: Path, keep: Scratch | None) -> str:
    """Returns the path relative to the temporary folder, or the path itself without one."""
    return str(path) if keep is None else path.relative_to(keep.path).as_posix()


def reopened(place: str, keep: Scratch | None) -> Path:
    """Returns the path of `place_in` in this process. Raises FileNotFoundError if nothing is there."""
    path = Path(place) if keep is None else keep.path / place
    if keep is None and not path.exists():
        raise FileNotFoundError(f"{path}: found nothing, expected the result that was pickled; it was moved or deleted")
    return path


def folder_for(folder: str | os.PathLike[str] | None) -> tuple[str, Scratch | None]:
    """Returns the folder, or a temporary one with the object that must exist as long as its files are needed."""
    if folder is not None:
        return os.fspath(folder), None
    keep = Scratch()
    return str(keep.path / "result"), keep
