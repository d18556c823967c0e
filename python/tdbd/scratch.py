"""Temporary folders that are deleted with the object that uses them."""

import os
import shutil
import tempfile
import weakref
from pathlib import Path


class Scratch:
    """A temporary folder. It is deleted with this object, or at the latest when Python exits."""

    def __init__(self) -> None:
        self.path = Path(tempfile.mkdtemp(prefix="tdbd-"))
        weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)


def folder_for(folder: str | os.PathLike[str] | None) -> tuple[str, Scratch | None]:
    """Returns the folder, or a temporary one with the object that must exist as long as its files are needed."""
    if folder is not None:
        return os.fspath(folder), None
    keep = Scratch()
    return str(keep.path / "result"), keep
