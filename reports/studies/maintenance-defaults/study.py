"""Comparison of the settings of [maintenance] (thesis 4.2.4.3 and 4.2.4.4) in four cases, by long-run.

Prints one table for each case. choices.csv has what was kept of them.
"""

import re

from study_tools import ROOT, markdown_table

# name: case, settings, revolutions
CASES = {
    "needle": ("standard-workload", ["rock.edge_length='1.5 mm'"], 6),
    "whirl": ("bit-b-whirl", ["rock.edge_length='3 mm'"], 25),
    "rolling": ("bit-r-rolling", ["rock.edge_length='3.5 mm'"], 15),
    "core": ("core", ["rock.edge_length='3 mm'"], 25),
}
CHOICES = {
    "defaults": "", **{f"every {n}": f"every={n}" for n in (1, 2, 10, 20)}, "flips off": "flip_quality=0",
    **{f"flips below {q}": f"flip_quality={q}" for q in (0.3, 0.5, 0.7)},
    **{f"smoothing below {q}": f"smoothing='tangential' smooth_quality={q}" for q in (0.3, 0.5)},
    "smoothing, no flips": "flip_quality=0 smoothing='tangential' smooth_quality=0.5",
    "worst quality 0.05": "worst_quality=0.05", "worst quality 0.2": "worst_quality=0.2", "edges 0.3 to 1.6": "shortest_edge=0.3",
    "edges 0.5 to 1.6": "shortest_edge=0.5", "edges 0.4 to 1.4": "longest_edge=1.4",
}
OPERATIONS = ("bisections", "collapses", "flips", "smoothings", "bluntings")


def figures(text, revolutions):
    """Pairs of triangles that intersect (CGAL), worst quality and the quality that 99 % exceed, volume that maintenance disturbed over
    the volume removed, CPU nanoseconds of maintenance a touched triangle, operations a revolution."""
    row = next(line for line in text.splitlines() if re.match(r" *\d+ +\d+\.\d\d ", line)).split()
    counts = {name: int(m[1]) if (m := re.search(rf"^{name} (\d+)$", text, re.M)) else 0 for name in OPERATIONS}
    return {"triangles": row[2], "pairs": row[3], "worst": row[4], "1 %": row[5], "disturbed": row[6], "ns a triangle": row[9],
            **{name: round(counts[name] / revolutions) for name in OPERATIONS}, "broken": " ".join(row[10:])}


def measure(m):
    """Parts for --only: needle, whirl, rolling, core."""
    for name, (case, settings, revolutions) in CASES.items():
        if not m.includes(name):
            continue
        found = {}
        for choice, keys in CHOICES.items():
            words = [w for s in [*settings, f"time.revolutions={revolutions}", *(f"maintenance.{k}" for k in keys.split())] for w in ("--set", s)]
            text = m.output("verification/long_run/long-run", ROOT / f"cases/{case}.toml", "--rows", "1", *words, codes=(0, 1))
            found[choice] = figures(text, revolutions)
        print(f"\n{name}: `cases/{case}.toml`\n\n" + markdown_table(["choice", *found["defaults"]], ([c, *f.values()] for c, f in found.items())), flush=True)
