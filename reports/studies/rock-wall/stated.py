"""The numbers of README.md, from the data of this study."""

from pathlib import Path

import numpy as np
from study_tools import read_csv, read_rows

HERE = Path(__file__).parent
TURNS = 2.0  # of the bit a second
GIVEN = ["weight (2 kN), speed (120 rpm) and friction (1)", "1e8 N/m, restitution 0.5, and a clearance of 3 mm",
         "edges of 1.5 mm and steps of 0.25 ms", "f/2 + 1", "0.5 mm high", "with 10 kN, or with a coefficient of 0.8",
         "at 1.5 mm they change", "from 0.25 to 0.125 ms", "From 3 to 1.05 mm", "varies between 0.5 and 1.1 mm/s",
         "changes by less than 0.3 %"]


def lobes():
    """The number of waves of the hole's radius with the greatest amplitude."""
    radius = np.array(read_csv(HERE / "sections.csv")["radius, mm"])
    waves = np.abs(np.fft.rfft(radius - radius.mean()))
    return int(np.argmax(waves[4:]) + 4)


def stated():
    rows = {(r["wall"], r["edges, mm"], r["step, ms"]): r for r in read_rows(HERE / "walls.csv")}
    rock, ring, shorter = rows["rock", 1.5, 0.25], rows["ring", 1.5, 0.25], rows["rock", 1.5, 0.125]
    coarse, fine = rows["rock", 3.0, 0.25], rows["rock", 1.05, 0.25]
    yield "whirls at {:.1f} Hz on a circle of {:.2f} mm on the", ring["whirl, Hz"], ring["orbit, mm"]
    yield "climbs at {:.2f} mm/s", -ring["advance, mm/s"]
    yield "In the rock it whirls at {:.1f} Hz on {:.2f}", rock["whirl, Hz"], rock["orbit, mm"]
    yield "mm, {:.0f} % of the speed", 100.0 * rock["whirl, Hz"] / rock["rolling on that orbit, Hz"]
    yield "with {:.0f} N m of torque and an advance of {:.2f} mm/s", rock["torque, N m"], rock["advance, mm/s"]
    yield "removes {:.0f} cm3 where the bit on the ring removes {:.1f} cm3", rock["removed, cm3"], ring["removed, cm3"]
    yield "Its hole has {:.0f} lobes", lobes()
    yield "which is {:.1f}", -rock["whirl, Hz"] / TURNS + 1.0
    yield "by {:.1f} % and {:.1f} % from", 100.0 * abs(shorter["whirl, Hz"] / rock["whirl, Hz"] - 1.0), 100.0 * abs(shorter["orbit, mm"] / rock["orbit, mm"] - 1.0)
    yield "falls from {:.1f} to {:.1f} Hz", -coarse["whirl, Hz"], -fine["whirl, Hz"]
    yield "grows from {:.2f} to {:.2f} mm", coarse["orbit, mm"], fine["orbit, mm"]
