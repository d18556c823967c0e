"""The table of the thesis's class diagrams (app. B) and the counterparts in TDBD, read from src/README.md."""

import re
from dataclasses import dataclass
from pathlib import Path

HEAD = "| thesis, app. B | class in the thesis | in TDBD | header |"
PLACE = re.compile(r"`([^`]+)`")


@dataclass(frozen=True)
class Row:
    figure: str
    theirs: str
    names: tuple  # types and functions
    files: tuple  # relative to src
    note: str  # the text beside the names


def row_of(line):
    figure, theirs, ours, where = (cell.strip() for cell in line.strip().strip("|").split("|"))
    return Row(figure, theirs, tuple(PLACE.findall(ours)), tuple(PLACE.findall(where)),
               PLACE.sub("", ours).strip(" ,;"))


def rows(root):
    """The rows in their order; none when the project has no such table."""
    path = Path(root) / "src/README.md"
    if not path.is_file():
        return []
    lines = path.read_text(encoding="utf-8").split("\n")
    start = lines.index(HEAD) + 2 if HEAD in lines else len(lines)
    end = next((k for k in range(start, len(lines)) if not lines[k].startswith("|")), len(lines))
    return [row_of(line) for line in lines[start:end]]
