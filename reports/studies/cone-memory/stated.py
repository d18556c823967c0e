"""The numbers of README.md, from the data of this study and the shape of bit R."""

import math
import tomllib
from pathlib import Path

from study_tools import read_csv, read_rows

HERE = Path(__file__).resolve().parent
GIVEN = ["simulation (2)", "Speed of cone 1 over the bit's", "turns 0.1 rad", "in which cone 1 turns by"]
REMEMBERED = 0.1  # rad of the bit, the default: simulation/case/case_motion.cpp


def spread(rows, same):
    """The largest spread of the mean speed, %, among rows of the same memory or step."""
    groups = [[row["mean speed"] for row in rows if row[same] == value] for value in {row[same] for row in rows}]
    return max(100.0 * (max(group) / min(group) - 1.0) for group in groups)


def share_of_pitch(speed):
    """What cone 1 turns while the bit turns what is remembered, over the pitch of its gage row."""
    bit = tomllib.loads((HERE.parents[2] / "cases/bits/bit-r.toml").read_text(encoding="utf-8"))
    gage = next(row for row in bit["cones"][0]["rows"] if row.get("gage"))
    return REMEMBERED * speed * gage["teeth"] / (2.0 * math.pi)


def stated():
    rows, fifty = read_rows(HERE / "speeds.csv"), read_csv(HERE / "fifty.csv")
    yield "neither on the memory ({:.1f} %) nor on the step ({:.2f} %", spread(rows, "step, ms"), spread(rows, "memory, ms")
    speeds, slips = fifty["mean speed"], [100.0 * s for s in fifty["slip of the gage row"]]
    yield "{:.2f} of the pitch of a gage row", share_of_pitch(speeds[0])
    yield "would roll at {:.2f} without slip", fifty["pure rolling of the gage row"][0]
    yield "its cones turn at {:.3f}, {:.3f} and {:.3f}", *speeds
    yield "slipping by {:.1f}, {:.1f} and {:.1f} %", *slips
