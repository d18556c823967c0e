"""The score of each module in each draw of mutants, from the tables of verdicts that scripts/mutate writes to results/mutation."""

from study_tools import ROOT, read_text

DRAWS = ("mutants", "fresh", "third", "fourth")
KILLED = ("failed", "crashed", "timed out")
SURVIVORS = ("function", "operator", "before", "after")
# Test programs of a module other than verify_MODULE.
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


def measure(m):
    """Reduces results/mutation/DRAW.csv to the scores and the survivors; mutants of an earlier draw are left out of the later ones."""
    scores, survivors, seen = [], [], set()
    for draw in DRAWS:
        headings, *lines = read_text(ROOT / f"results/mutation/{draw}.csv")
        rows = [row for row in (dict(zip(headings, line)) for line in lines) if mutant(row) not in seen]
        seen |= set(map(mutant, rows))
        scores += [score(draw, module, [row for row in rows if row["module"] == module]) for module in sorted({row["module"] for row in rows})]
        survivors += [{"draw": draw, **{key: row[key] for key in SURVIVORS}} for row in rows if row["verdict"] == "survived"]
    m.write("scores.csv", scores)
    m.write("survivors.csv", survivors)
