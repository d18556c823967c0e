#!/usr/bin/python3
"""Intersecting pairs in the cases of this study with untangling, as long-run counts them. Writes now.csv and core.csv
beside itself; six minutes; requires a release build.

    measure.py [--build FOLDER]
"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_runs import ROOT, build_folder, found, write_csv  # noqa: E402

COARSE_STEPS = {"motion.rate_of_penetration": "'60 m/h'", "time.step": "'5 ms'", "time.revolutions": "4"}
# the row of pairs.csv, the case, its settings, how often its surface is looked at
CASES = [
    ("`bit-b-continues`, 20 rows", "bit-b-continues", {}, 20),
    ("`bit-b-sideways`, 10 rows", "bit-b-sideways", {}, 10),
    ("`bit-r-steady`, 20 m/h, 3 mm, 20 revolutions, 20 rows", "bit-r-steady",
     {"motion.rate_of_penetration": "'20 m/h'", "rock.edge_length": "'3 mm'", "time.revolutions": "20"}, 20),
    ("`bit-c-steady`, 60 m/h in steps of 5 ms, 2 mm, 4 revolutions, 4 rows", "bit-c-steady",
     {**COARSE_STEPS, "rock.edge_length": "'2 mm'"}, 4),
    ("the same at 3 mm", "bit-c-steady",
     {**COARSE_STEPS, "rock.edge_length": "'3 mm'"}, 4),
    ("`bit-r-steady`, 20 m/h, 2.5 mm, 50 revolutions, 10 rows", "bit-r-steady",
     {"motion.rate_of_penetration": "'20 m/h'", "rock.edge_length": "'2.5 mm'", "time.revolutions": "50"}, 10),
]
HEADINGS = ["case", "pairs at most", "pairs at the end", "worst triangle", "disturbed at most", "untanglings",
            "us a touched triangle at most"]


def drilled(program, case, settings, rows):
    """What long-run prints. Its exit code says that a promise is broken, as pairs are."""
    words = [w for key, value in settings.items() for w in ("--set", f"{key}={value}")]
    run = subprocess.run([program, ROOT / f"cases/{case}.toml", *words, "--rows", str(rows)], capture_output=True, text=True, check=False)
    if run.returncode > 1:
        raise SystemExit(run.stderr)
    return run.stdout


def figures(told):
    """Of all rows: steps, depth, triangles, pairs, worst, 1 %, disturbed, change, us a step, ns a triangle, broken."""
    lines = told.splitlines()[2:]
    table = lines[:next(i for i, line in enumerate(lines) if line.startswith("vertices moved"))]
    rows = [words for words in map(str.split, table) if len(words) > 10 and words[0].isdigit()]  # not broken promises
    pairs, worst, disturbed, ns = ([float(row[i]) for row in rows] for i in (3, 4, 6, 9))
    untanglings = found(r"(?m)^untanglings (\d+)", told)[0] if "\nuntanglings " in told else 0
    return [f"{max(pairs):.0f}", f"{pairs[-1]:.0f}", f"{min(worst):.3f}", f"{max(disturbed):.1e}", f"{untanglings:.0f}",
            f"{1e-3 * max(ns):.1f}"]


# `bit-c-steady` at 60 m/h over edge lengths and steps, ms: the bit leaves a core of 1 mm in radius
CORE_EDGES, CORE_STEPS = [1.6, 1.8, 2, 2.2, 2.5], [2.5, 4, 5, 6.25]
CORE_HEADINGS = ["edges, mm", *(f"{kind}, {step:g} ms" for step in CORE_STEPS for kind in ("at most", "at the end"))]


def core_row(program, edges):
    """The most pairs in twenty looks, and those at the end, for every step."""
    row = [f"{edges:g}"]
    for step in CORE_STEPS:
        settings = {**COARSE_STEPS, "time.step": f"'{step:g} ms'", "rock.edge_length": f"'{edges:g} mm'"}
        row += figures(drilled(program, "bit-c-steady", settings, 20))[:2]
    return row


def main():
    program = build_folder(__doc__) / "verification/long_run/long-run"
    write_csv(HERE / "core.csv", CORE_HEADINGS, *(core_row(program, edges) for edges in CORE_EDGES))
    rows = [[name, *figures(drilled(program, case, settings, rows))] for name, case, settings, rows in CASES]
    write_csv(HERE / "now.csv", HEADINGS, *rows)


if __name__ == "__main__":
    main()
