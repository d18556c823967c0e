"""The numbers of README.md, from the data of this study."""

from pathlib import Path

import numpy as np
from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["2500 m", "Edges of 5 mm and steps of 2 ms", "edges of 2 mm", "the first 14 s of 24 s", "severity above 0.5", "torque that 80 kN need", "at 80 rpm",
         "up to 100 rpm", "No point at 50 kN", "with edges of 3.5 mm", "with steps of 1 ms", "100 rpm, bit B still sticks at 50 and 65 kN", "Weights above 80 kN", "some 15 s", "at 5 mm a turn", "**The 3-D bit.**"]
STICKS = 0.5  # severity above which a point counts as stick-slip


def line(rows, key):
    """(slope per metre of depth, intercept) at the middle speed."""
    chosen = [r for r in rows if float(r["rpm"]) == 80.0]
    return np.polyfit([1e-3 * float(r["depth_mm"]) for r in chosen], [float(r[key]) for r in chosen], 1)


def stated():
    forces, rock, simple, levels = (read_rows(HERE / f"{name}.csv") for name in ("forces", "map", "simple", "levels"))
    number = lambda row, key: float(row[key])
    (k, w0), (t, t0) = line(forces, "weight_n"), line(forces, "torque_n_m")
    yield "weight = {:.1f} kN + {:.2f} kN/mm d and torque = {:.2f} kN m + {:.3f} kN m/mm d", 1e-3 * w0, 1e-6 * k, 1e-3 * t0, 1e-6 * t
    slow, fast = (next(r for r in forces if float(r["rpm"]) == rpm) for rpm in (40.0, 140.0))
    yield "from {:.2f} kN m at {:.0f} rpm to {:.2f} kN m at {:.0f} rpm", 1e-3 * number(slow, "torque_n_m"), 40.0, 1e-3 * number(fast, "torque_n_m"), 140.0
    count = lambda rows: sum(number(r, "severity") > STICKS for r in rows)
    yield "{:.0f} of {:.0f} points stick and slip, with the simple bit {:.0f}", count(rock), len(rock), count(simple)
    yield "swings by {:.0f} % to {:.0f} % of its mean in rock and by {:.0f} % to {:.0f} % with the simple bit", \
        *(100.0 * f(number(r, "weight_swing") for r in rows) for rows in (rock, simple) for f in (min, max))
    yield "leaves the bottom for up to {:.0f} % of the time; bit B never", 100.0 * max(number(r, "lost_contact_share") for r in simple)
    ratios = [number(a, "rate_mm_s") / number(b, "rate_mm_s") for a, b in zip(rock, simple)]
    yield "rate in rock is {:.2f} to {:.2f} times that of the simple bit", min(ratios), max(ratios)
    for first in range(0, len(levels), 3):
        base, finer, shorter = levels[first:first + 3]
        yield "At {:.0f} kN and {:.0f} rpm " + ("it is" if first else "the severity is") + " {:.3f}, with edges of 3.5 mm {:.3f}, with steps of 1 ms {:.3f}", number(base, "weight_kn"), \
            number(base, "rpm"), number(base, "severity"), number(finer, "severity"), number(shorter, "severity")
        yield "{:.2f}, {:.2f} and {:.2f} mm/s" + (" there" if first else " here"), *(number(r, "rate_mm_s") for r in (base, finer, shorter))
