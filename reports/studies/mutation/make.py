"""make.py OUT: the score of each room, and the mutants that no test noticed: from mutants.csv, whose survivors were mended, and from the draws
DRAWS, each written down as its mutants first met the tests."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table  # noqa: E402

KILLED = ("failed", "crashed", "timed out")
# File, and when: the last one tells what to expect of a fault that somebody makes tomorrow.
DRAWS = {"fresh.csv": "A second draw, of 2026-11-24 (seed 11)", "third.csv": "A third draw, of 2026-11-25 (seed 23), after tests had been written for the second one",
         "fourth.csv": "A fourth draw, of 2026-11-25 (seed 29), after tests had been written for the third one"}
CORE = ("rock", "dynamics", "forces", "mesh", "bit", "calibration")


def score(name, rows):
    n = {v: sum(row["verdict"] == v for row in rows) for v in (*KILLED, "survived", "equivalent", "compiler")}
    killed = sum(n[v] for v in KILLED)
    judged = killed + n["survived"]
    # A kill is at home when a test that is written for the room sees it.
    home = sum(row["verdict"] in KILLED and is_home(row) for row in rows)
    share = f"{100.0 * killed / judged:.1f}" if judged else ""
    wanted = "" if name == "all" else "95" if name in CORE else "90"
    return [name, killed, judged, share, wanted, home, n["timed out"], n["survived"], n["equivalent"], n["compiler"]]


def is_home(row):
    programs = {"dynamics": ("verify_dynamics", "verify_drilling"), "calibration": ("verify_calibration", "verify_calibrate"),
                "app": ("verify_app", "verify_calibrate")}
    return row["killer"].split(" ")[0] in programs.get(row["room"], ("verify_" + row["room"],))


def code(text):
    return f"`{text}`"


HEAD = ["room", "killed", "of", "%", "wanted", "by the room's own tests", "timed out", "survived", "equivalent", "refused by the compiler"]


def table_of(rows):
    rooms = sorted({row["room"] for row in rows})
    scores = [score(room, [row for row in rows if row["room"] == room]) for room in rooms] + [score("all", rows)]
    survivors = [[f"{row['file']}:{row['line']}", row["operator"], code(row["before"]), code(row["after"])]
                 for row in rows if row["verdict"] == "survived"]
    return markdown_table(HEAD, scores) + "\n" + markdown_table(["survivor", "operator", "line", "became"], survivors)


def not_in(known, rows):
    """Those of a draw that are in no other: a line may have moved."""
    seen = {(row["file"], row["before"], row["after"]) for row in known}
    return [row for row in rows if (row["file"], row["before"], row["after"]) not in seen]


def rows_of(name):
    with (HERE / name).open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(out):
    known = rows_of("mutants.csv")
    text = "The sample of each room, asked again until its tests were written.\n\n" + table_of(known)
    for name, title in DRAWS.items():
        rows = not_in(known, rows_of(name))
        text += f"\n{title}, as its mutants first met the tests; those of earlier draws are left out.\n\n" + table_of(rows)
        known += rows
    (Path(out) / "table.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(sys.argv[1])
