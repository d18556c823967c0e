"""A folder that goes with the object that needs it."""

import os
import shutil
import tempfile
import weakref
from pathlib import Path


class Scratch:
    """A temporary folder. It goes with this object, and at the end of Python at the latest."""

    def __init__(self) -> None:
        self.path = Path(tempfile.mkdtemp(prefix="tdbd-"))
        weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)


def folder_for(folder: str | os.PathLike[str] | None) -> tuple[str, Scratch | None]:
    """The folder, or one in a temporary one, which must be kept as long as its files are needed."""
    if folder is not None:
        return os.fspath(folder), None
    keep = Scratch()
    return str(keep.path / "result"), keep
