"""The numbers of README.md, from the data of this study."""

import math
from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
STEPS, DEFAULT = 5000, 2500  # of 10 revolutions; between two renumberings
GIVEN = ["The standard workload (1.0 mm)", "in 16 to 24 blocks of 100 steps", "after 20 revolutions", "10 and 20 revolutions",
         "in 5000 steps", "with 2500 it is", "The default is 2500", "A run of 20 revolutions"]


def gains(start, revolutions):
    """What numbering by place saves of a step, percent: of each measurement."""
    times = read_csv(HERE / "times.csv")
    rows = zip(times["start numbered by"], times["revolutions"], times["step renumbered by place over as it is"])
    return [100.0 * (1.0 - ratio) for by, n, ratio in rows if by == start and n in revolutions]


def renumbering():
    """What one costs after 10 revolutions, in steps."""
    costs = read_csv(HERE / "renumbering.csv")
    return costs["in steps"][costs["revolutions"].index(10)]


def lost(interval, loss):
    """Percent of all time with an interval: the mean of a loss that grows evenly to `loss` in STEPS, and the renumberings."""
    return loss * interval / STEPS / 2.0 + 100.0 * renumbering() / interval


def stated():
    loss = gains("place", [10])[0]
    best = math.sqrt(100.0 * renumbering() * 2.0 * STEPS / loss)
    late, remaining = gains("rings", [20]), gains("place", [10, 20])
    yield "the start's rings cost {:.0f} % of a step", *gains("rings", [1])
    yield "after 20 revolutions {:.0f} to {:.0f} % of a step are lost", min(late), max(late)
    yield "10 and 20 revolutions is {:.0f} to {:.0f} %", min(remaining), max(remaining)
    yield "evenly to {:.0f} % in 5000 steps and a renumbering costs {:.0f} steps", loss, renumbering()
    yield "with an interval of {:.0f} steps, {:.1f} %; with 2500 it is {:.1f} %", round(best, -2), lost(best, loss), lost(DEFAULT, loss)
    yield "is renumbered costs {:.1f} and {:.1f} % less", *[100.0 * (1.0 - r) for r in read_csv(HERE / "long-runs.csv")["whole run"]]
