"""Exceptions by kind of problem. Messages name the arguments and functions of Python."""

import re
from typing import NamedTuple

_FUNCTIONS = {"run": "run", "rotate": "rotate", "calibrate": "calibrate", "laboratory": "laboratory",
              "converge": "converge", "check": "check", "bit": "bit.read", "sweep": "sweep.run", "mesh": "mesh.read"}
_REWORDED = [
    (re.compile(r"^--set: ", re.M), ""),
    (re.compile(r"^bit\.set: ", re.M), "bit.set."),
    (re.compile(r"--force (?=overwrites|replaces)"), "force=True "),
    (re.compile(r"\(or --force\)"), "(or force=True)"),
    (re.compile(r"; to resume it: tdbd \w+ --resume (.+)"), r"; to resume it: tdbd.resume"),
    (re.compile(r": to (?:try a )?repair: tdbd mesh .+"), ": tdbd.mesh.repair may repair it"),
    (re.compile(r"tdbd mesh --repair cannot repair this"), "tdbd.mesh.repair cannot repair this"),
    (re.compile(r"; try: tdbd (\w+)(?: .+)?"), lambda found: _advice(found[1])),
]
_OPTION = re.compile(r"(?<![\w-])--([a-z][a-z-]*)(?: (?=[\d'\"]))?")
_COMMAND = re.compile(rf"\btdbd ({'|'.join(_FUNCTIONS)})\b")
_PLACED = re.compile(r"(?P<file>.+?):(?P<line>\d+)(?::\d+)?: (?:(?P<key>[^\s:]+): )?(?P<text>.+)", re.DOTALL)
_OF_KEY = re.compile(r"(?P<key>[\w.\[\]-]+): (?P<text>found .+)", re.DOTALL)
_OF_FILE = re.compile(r"(?P<file>.+?): (?P<text>found .+)", re.DOTALL)
_FOUND = re.compile(r"found (?P<found>.+?)(?:,|;) expected (?P<expected>.+?)(?:; try: .+)?", re.DOTALL)
_FOLDER = re.compile(r"(?:output folder )?(?P<folder>.+?): (?P<reason>.+)", re.DOTALL)


def _advice(command: str) -> str:
    return f"; try: tdbd.{_FUNCTIONS[command]}" if command in _FUNCTIONS else ""


def in_python_words(message: str) -> str:
    """Rewords a message of the command line: `--force` becomes `force=True`, `tdbd rotate` becomes `tdbd.rotate`."""
    for pattern, words in _REWORDED:
        message = pattern.sub(words, message)
    message = _COMMAND.sub(lambda found: f"tdbd.{_FUNCTIONS[found[1]]}", message)
    return _OPTION.sub(lambda found: found[1].replace("-", "_") + ("=" if found[0].endswith(" ") else ""), message)


class Mistake(NamedTuple):
    """One mistake of a case."""

    file: str  #: as given; "" for an override or argument, or if the message contains none
    line: int  #: from 1; 0 for an override or if the message contains none
    key: str  #: dotted, or the name of an argument; "" if the message contains none
    text: str  #: value found, and value expected

    @property
    def found(self) -> str:
        """The value found; "" if the message has another form."""
        match = _FOUND.fullmatch(self.text)
        return match["found"] if match else ""

    @property
    def expected(self) -> str:
        """The value expected; "" if the message has another form."""
        match = _FOUND.fullmatch(self.text)
        return match["expected"] if match else ""


def _mistake(line: str) -> Mistake:
    if placed := _PLACED.fullmatch(line):
        return Mistake(placed["file"], int(placed["line"]), placed["key"] or "", placed["text"])
    if of_key := _OF_KEY.fullmatch(line):
        if "/" not in of_key["key"] and not of_key["key"].endswith((".toml", ".csv", ".stl", ".obj", ".ply", ".off")):
            return Mistake("", 0, of_key["key"], of_key["text"])
    if of_file := _OF_FILE.fullmatch(line):
        return Mistake(of_file["file"], 0, "", of_file["text"])
    return Mistake("", 0, "", line)


class CaseError(ValueError):
    """A case, or a file that it names, is wrong. The message has one line for each mistake.

    `file`, `line`, `key`, `found` and `expected` are those of the first mistake.
    """

    @property
    def mistakes(self) -> list[Mistake]:
        """All mistakes, in the order of the message."""
        return [_mistake(line) for line in str(self).split("\n")]

    @property
    def file(self) -> str:
        """File of the first mistake; "" for an override."""
        return self.mistakes[0].file

    @property
    def line(self) -> int:
        """Line of the first mistake; 0 if it has none."""
        return self.mistakes[0].line

    @property
    def key(self) -> str:
        """Key of the first mistake."""
        return self.mistakes[0].key

    @property
    def found(self) -> str:
        """The value found by the first mistake."""
        return self.mistakes[0].found

    @property
    def expected(self) -> str:
        """The value expected by the first mistake."""
        return self.mistakes[0].expected


class FolderError(FileExistsError):
    """A result folder is rejected: not empty, in use, not one of TDBD, or not writable. Nothing was changed."""

    @property
    def folder(self) -> str:
        """The folder or file that is rejected."""
        match = _FOLDER.fullmatch(str(self))
        return match["folder"] if match else ""

    @property
    def reason(self) -> str:
        """Why it is rejected."""
        match = _FOLDER.fullmatch(str(self))
        return match["reason"] if match else str(self)


class RunError(RuntimeError):
    """The computation failed: the surface violates an invariant, a motion diverges, or a disk is full."""


class CaseWarning(UserWarning):
    """A setting without effect, or a result to be used with care. TDBD warns and continues."""
