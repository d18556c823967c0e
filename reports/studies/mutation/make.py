"""make.py OUT: the score of each module in each draw (scores.csv), and the mutants that no test killed (survivors.csv)."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table  # noqa: E402

TITLES = {"mutants": "The sample of each module; tests were written for its survivors, and the score is that of the tests with these.",
          "fresh": "A second draw, of 2026-11-24 (seed 11), before any test was written for it; mutants of earlier draws are left out.",
          "third": "A third draw, of 2026-11-25 (seed 23), after tests had been written for the second one, as above.",
          "fourth": "A fourth draw, of 2026-11-25 (seed 29), after tests had been written for the third one, as above."}
CORE = ("rock", "dynamics", "forces", "mesh", "bit", "calibration")
HEAD = ["module", "killed", "of", "%", "required", "by the module's own tests", "timed out", "survived", "equivalent", "rejected by the compiler"]
COUNTS = ("killed", "judged", "home", "timed out", "survived", "equivalent", "compiler")


def rows_of(name):
    with (HERE / name).open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def line(name, row):
    n = [int(row[key]) for key in COUNTS]
    share = f"{100.0 * n[0] / n[1]:.1f}" if n[1] else ""
    required = "" if name == "all" else "95" if name in CORE else "90"
    return [name, n[0], n[1], share, required, *n[2:]]


def table_of(draw):
    rows = [row for row in rows_of("scores.csv") if row["draw"] == draw]
    every = {key: sum(int(row[key]) for row in rows) for key in COUNTS}
    survivors = [[f"`{row['function']}`", row["operator"], f"`{row['before']}`", f"`{row['after']}`"]
                 for row in rows_of("survivors.csv") if row["draw"] == draw]
    scores = [line(row["module"], row) for row in rows] + [line("all", every)]
    return markdown_table(HEAD, scores) + "\n" + markdown_table(["survived in", "operator", "line", "mutation"], survivors)


def write(out):
    text = "\n".join(f"{title}\n\n{table_of(draw)}" for draw, title in TITLES.items())
    (Path(out) / "table.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(sys.argv[1])
