"""make.py OUT: how many checks of each folder of tests are of which kind, and the loose ones, from checks.csv."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table  # noqa: E402

KINDS = ("tight", "bound", "said", "rounding", "loose")


def line(name, rows):
    return [name, len(rows), *(sum(row["kind"] == kind for row in rows) for kind in KINDS)]


def write(out):
    with (HERE / "checks.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    rooms = sorted({row["file"].split("/")[1] for row in rows})
    counts = [line(room, [row for row in rows if row["file"].split("/")[1] == room]) for room in rooms] + [line("all", rows)]
    loose = [[f"{row['file']}:{row['line']}", row["observed"], row["allowed"], f"`{row['words']}`"] for row in rows if row["kind"] == "loose"]
    text = markdown_table(["tests of", "checks", *KINDS], counts)
    if loose:
        text += "\n" + markdown_table(["loose", "observed", "allowed", "words"], loose)
    out.mkdir(parents=True, exist_ok=True)
    (out / "table.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
