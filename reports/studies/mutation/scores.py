"""scores.py FOLDER: reduces the tables of verdicts that scripts/mutate wrote to FOLDER (README.md has the commands) to scores.csv and
survivors.csv, which make.py shows. FOLDER has one table for each of DRAWS; mutants of an earlier table are left out of the later ones."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
DRAWS = ("mutants", "fresh", "third", "fourth")
KILLED = ("failed", "crashed", "timed out")
SCORES = ("draw", "module", "killed", "judged", "home", "timed out", "survived", "equivalent", "compiler")
SURVIVORS = ("draw", "function", "operator", "before", "after")
# The programs whose kills count as the module's own, where it has others than verify_MODULE.
PROGRAMS = {"dynamics": ("verify_dynamics", "verify_drilling"), "calibration": ("verify_calibration", "verify_calibrate"),
            "app": ("verify_app", "verify_calibrate")}


def is_home(row):
    return row["verdict"] in KILLED and row["killer"].split(" ")[0] in PROGRAMS.get(row["module"], ("verify_" + row["module"],))


def score(draw, module, rows):
    n = {v: sum(row["verdict"] == v for row in rows) for v in (*KILLED, "survived", "equivalent", "compiler")}
    killed = sum(n[v] for v in KILLED)
    return {"draw": draw, "module": module, "killed": killed, "judged": killed + n["survived"], "home": sum(map(is_home, rows)),
            **{v: n[v] for v in ("timed out", "survived", "equivalent", "compiler")}}


def mutant(row):
    return row["function"], row["before"], row["after"]


def reduced(tables):
    """(rows of scores.csv, rows of survivors.csv) of {draw: rows}."""
    scores, survivors, seen = [], [], set()
    for draw, rows in tables.items():
        rows = [row for row in rows if mutant(row) not in seen]
        seen |= set(map(mutant, rows))
        for module in sorted({row["module"] for row in rows}):
            scores.append(score(draw, module, [row for row in rows if row["module"] == module]))
        survivors += [{"draw": draw, **{key: row[key] for key in SURVIVORS[1:]}} for row in rows if row["verdict"] == "survived"]
    return scores, survivors


def write(name, columns, rows):
    with (HERE / name).open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, columns, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def main(folder):
    tables = {}
    for draw in DRAWS:
        with (Path(folder) / f"{draw}.csv").open(newline="", encoding="utf-8") as file:
            tables[draw] = list(csv.DictReader(file))
    scores, survivors = reduced(tables)
    write("scores.csv", SCORES, scores)
    write("survivors.csv", SURVIVORS, survivors)


if __name__ == "__main__":
    main(sys.argv[1])
