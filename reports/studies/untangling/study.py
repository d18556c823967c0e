"""Intersecting pairs in the cases of this study with untangling, as long-run counts them."""

from study_runs import found
from study_tools import ROOT

COARSE_STEPS = {"motion.rate_of_penetration": "'60 m/h'", "time.step": "'5 ms'", "time.revolutions": "4"}
# the row of pairs.csv, the case, its settings, the number of checks of its surface
CASES = [
    ("`bit-b-continues`, 20 rows", "bit-b-continues", {}, 20),
    ("`bit-b-sideways`, 10 rows", "bit-b-sideways", {}, 10),
    ("`bit-r-steady`, 20 m/h, 3 mm, 20 revolutions, 20 rows", "bit-r-steady",
     {"motion.rate_of_penetration": "'20 m/h'", "rock.edge_length": "'3 mm'", "time.revolutions": "20"}, 20),
    ("`bit-c-steady`, 60 m/h in steps of 5 ms, 2 mm, 4 revolutions, 4 rows", "bit-c-steady", {**COARSE_STEPS, "rock.edge_length": "'2 mm'"}, 4),
    ("the same at 3 mm", "bit-c-steady", {**COARSE_STEPS, "rock.edge_length": "'3 mm'"}, 4),
    ("`bit-r-steady`, 20 m/h, 2.5 mm, 50 revolutions, 10 rows", "bit-r-steady",
     {"motion.rate_of_penetration": "'20 m/h'", "rock.edge_length": "'2.5 mm'", "time.revolutions": "50"}, 10),
]
HEADINGS = ["pairs at most", "pairs at the end", "worst triangle", "disturbed at most", "untanglings", "us a touched triangle at most"]
# `bit-c-steady` at 60 m/h over edge lengths, mm, and steps, ms. The bit leaves a core with a radius of 1 mm.
CORE_EDGES, CORE_STEPS = [1.6, 1.8, 2, 2.2, 2.5], [2.5, 4, 5, 6.25]


def figures(m, case, settings, rows):
    """All rows that long-run prints: steps, depth, triangles, pairs, worst, 1 %, disturbed, change, us a step, ns a triangle, broken.
    Exit code 1 means that a promise is broken, which includes pairs."""
    words = [w for key, value in settings.items() for w in ("--set", f"{key}={value}")]
    text = m.output("verification/long_run/long-run", ROOT / f"cases/{case}.toml", *words, "--rows", str(rows), codes=(0, 1))
    lines = text.splitlines()[2:]
    table = lines[:next(i for i, line in enumerate(lines) if line.startswith("vertices moved"))]
    rows = [words for words in map(str.split, table) if len(words) > 10 and words[0].isdigit()]  # not broken promises
    pairs, worst, disturbed, ns = ([float(row[i]) for row in rows] for i in (3, 4, 6, 9))
    untanglings = found(r"(?m)^untanglings {n}", text)[0] if "\nuntanglings " in text else 0
    return [f"{max(pairs):.0f}", f"{pairs[-1]:.0f}", f"{min(worst):.3f}", f"{max(disturbed):.1e}", f"{untanglings:.0f}", f"{1e-3 * max(ns):.1f}"]


def core_row(m, edges):
    """The largest number of pairs in twenty checks, and the number at the end, for every step."""
    row = {"edges, mm": f"{edges:g}"}
    for step in CORE_STEPS:
        settings = {**COARSE_STEPS, "time.step": f"'{step:g} ms'", "rock.edge_length": f"'{edges:g} mm'"}
        row[f"at most, {step:g} ms"], row[f"at the end, {step:g} ms"] = figures(m, "bit-c-steady", settings, 20)[:2]
    return row


def measure(m):
    m.write("core.csv", (core_row(m, edges) for edges in CORE_EDGES))
    m.write("now.csv", ({"case": name, **dict(zip(HEADINGS, figures(m, *run), strict=True))} for name, *run in CASES))
