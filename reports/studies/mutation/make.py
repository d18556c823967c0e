"""make.py OUT: the score of each room, and the mutants that no test noticed, from mutants.csv."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table  # noqa: E402

KILLED = ("failed", "crashed", "timed out")
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


def write(rows, out):
    rooms = sorted({row["room"] for row in rows})
    scores = [score(room, [row for row in rows if row["room"] == room]) for room in rooms] + [score("all", rows)]
    survivors = [[f"{row['file']}:{row['line']}", row["operator"], code(row["before"]), code(row["after"])]
                 for row in rows if row["verdict"] == "survived"]
    text = markdown_table(["room", "killed", "of", "%", "wanted", "by the room's own tests", "timed out", "survived", "equivalent", "refused by the compiler"],
                          scores)
    text += "\n" + markdown_table(["survivor", "operator", "line", "became"], survivors)
    (Path(out) / "table.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    with (HERE / "mutants.csv").open(newline="", encoding="utf-8") as file:
        write(list(csv.DictReader(file)), sys.argv[1])
