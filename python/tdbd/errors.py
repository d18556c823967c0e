"""What goes wrong, by kind. The words are those of the command line."""

import re
from typing import NamedTuple

_PLACED = re.compile(r"(?:(?P<set>--set)|(?P<file>.+?):(?P<line>\d+)(?::\d+)?): (?:(?P<key>[^\s:]+): )?(?P<text>.+)", re.DOTALL)
_OF_FILE = re.compile(r"(?P<file>.+?): (?P<text>found .+)", re.DOTALL)


class Mistake(NamedTuple):
    """One mistake of a case."""

    file: str  #: as it was given; "--set" of an override; "" where the message names none
    line: int  #: from 1; 0 of an override, and where the message names none
    key: str  #: dotted; "" where the message names none
    text: str  #: what was found, what is expected


def _mistake(line: str) -> Mistake:
    if placed := _PLACED.fullmatch(line):
        return Mistake(placed["set"] or placed["file"], int(placed["line"] or 0), placed["key"] or "", placed["text"])
    if of_file := _OF_FILE.fullmatch(line):
        return Mistake(of_file["file"], 0, "", of_file["text"])
    return Mistake("", 0, "", line)


class CaseError(ValueError):
    """A case, or a file that it names, is wrong. Its message has a line for each mistake."""

    @property
    def mistakes(self) -> list[Mistake]:
        """All mistakes, in the order of the message."""
        return [_mistake(line) for line in str(self).split("\n")]

    @property
    def file(self) -> str:
        """Of the first mistake."""
        return self.mistakes[0].file

    @property
    def line(self) -> int:
        """Of the first mistake."""
        return self.mistakes[0].line

    @property
    def key(self) -> str:
        """Of the first mistake."""
        return self.mistakes[0].key


class FolderError(FileExistsError):
    """A folder for results is refused: it is not empty, in use, not TDBD's, or cannot be written to. Nothing was changed."""


class RunError(RuntimeError):
    """The computation failed: a broken promise of the rock's surface, a motion that diverges, a full disk."""


class CaseWarning(UserWarning):
    """A setting without effect. TDBD warns and continues."""
