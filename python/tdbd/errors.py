"""Exceptions by kind of problem. Their messages are those of the command line."""

import re
from typing import NamedTuple

_PLACED = re.compile(r"(?:(?P<set>--set)|(?P<file>.+?):(?P<line>\d+)(?::\d+)?): (?:(?P<key>[^\s:]+): )?(?P<text>.+)", re.DOTALL)
_OF_FILE = re.compile(r"(?P<file>.+?): (?P<text>found .+)", re.DOTALL)


class Mistake(NamedTuple):
    """One mistake of a case."""

    file: str  #: as given; "--set" for an override; "" if the message contains none
    line: int  #: from 1; 0 for an override or if the message contains none
    key: str  #: dotted; "" if the message contains none
    text: str  #: value found, and value expected


def _mistake(line: str) -> Mistake:
    if placed := _PLACED.fullmatch(line):
        return Mistake(placed["set"] or placed["file"], int(placed["line"] or 0), placed["key"] or "", placed["text"])
    if of_file := _OF_FILE.fullmatch(line):
        return Mistake(of_file["file"], 0, "", of_file["text"])
    return Mistake("", 0, "", line)


class CaseError(ValueError):
    """A case, or a file that it names, is wrong. The message has one line for each mistake."""

    @property
    def mistakes(self) -> list[Mistake]:
        """All mistakes, in the order of the message."""
        return [_mistake(line) for line in str(self).split("\n")]

    @property
    def file(self) -> str:
        """File of the first mistake."""
        return self.mistakes[0].file

    @property
    def line(self) -> int:
        """Line of the first mistake."""
        return self.mistakes[0].line

    @property
    def key(self) -> str:
        """Key of the first mistake."""
        return self.mistakes[0].key


class FolderError(FileExistsError):
    """A result folder is rejected: not empty, in use, not one of TDBD, or not writable. Nothing was changed."""


class RunError(RuntimeError):
    """The computation failed: the surface violates an invariant, a motion diverges, or a disk is full."""


class CaseWarning(UserWarning):
    """A setting without effect. TDBD warns and continues."""
