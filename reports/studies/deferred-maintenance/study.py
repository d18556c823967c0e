"""Effect of the number of steps without a move before maintenance (`maintenance.rest`): the standard workload, by long-run."""

import re

import numpy as np
from result import distances, heights, read_ply
from study_tools import ROOT

CELL, REACH = 0.25e-3, 0.107  # m


def drill(m, edges, rest):
    """The output of long-run, and the heights of its final surface."""
    ply = m.temporary / "rock.ply"
    settings = (f"rock.edge_length='{edges} mm'", f"maintenance.rest={rest}", "time.revolutions=3")
    text = m.output("verification/long_run/long-run", ROOT / "cases/standard-workload.toml", "--rows", "1", "--save", ply,
                    *(w for s in settings for w in ("--set", s)), codes=(0, 1))
    return text, heights(*read_ply(ply), REACH, CELL)


def figures(text):
    row = next(line for line in text.splitlines() if re.match(r" *\d+ +\d+\.\d\d ", line)).split()

    def number(pattern):
        found = re.search(pattern, text, re.M)
        return float(found[1]) if found else 0.0

    return {"bisections in 1000 steps": f"{number('^bisections ([0-9]+)') / (float(row[0]) / 1000):.0f}",
            "triangles at the end": row[2], "moves a step": f"{number('by a step of the last row ([0-9.]+)'):.0f}", "worst quality": row[4],
            "1 % quality": row[5], "disturbed over removed": row[6], "us a plain step": row[8], "ns a touched triangle": row[9],
            "pairs": row[3], "broken promises": " ".join(row[10:])}


def rows(m):
    _, fine = drill(m, "0.5", 0)
    for rest in (0, 1, 2, 4):
        text, z = drill(m, "1.0", rest)
        apart = 1e3 * distances(fine, z, REACH, CELL, 2e-3, 0.106)
        yield {"edges, mm": "1.0", "rest, steps": rest, **figures(text),
               "surface error, mean and p95, mm": f"{apart.mean():.4f}, {np.percentile(apart, 95):.4f}"}


def measure(m):
    m.write("rests.csv", rows(m))
