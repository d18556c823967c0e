"""make.py OUT: the number of checks of each kind in each folder of tests, from counts.csv."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table  # noqa: E402

KINDS = ("tight", "bound", "said", "rounding", "loose")


def line(name, rows):
    counts = [sum(int(row[kind]) for row in rows) for kind in KINDS]
    return [name, sum(counts), *counts]


def write(out):
    with (HERE / "counts.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    out.mkdir(parents=True, exist_ok=True)
    counts = [line(row["tests of"], [row]) for row in rows] + [line("all", rows)]
    (out / "table.md").write_text(markdown_table(["tests of", "checks", *KINDS], counts), encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
