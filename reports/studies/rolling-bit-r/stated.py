"""The numbers of README.md, from the data of this study and from the file of the bit."""

import tomllib
from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
FITS = 10  # revolutions until the bottom fits the bit
GIVEN = ["turns at 90 rpm and advances 8 m/h", "on edges of 2.5 mm"]


def teeth():
    bit = tomllib.loads((HERE.parents[2] / "cases/bits/bit-r.toml").read_text(encoding="utf-8"))
    return sum(row["teeth"] for cone in bit["cones"] for row in cone["rows"])


def late_speeds():
    """Of the cones over the bit's, mean of each revolution."""
    speeds = read_csv(HERE / "cone_speeds.csv")
    return [v for name, values in speeds.items() if name != "revolution" for n, v in zip(speeds["revolution"], values) if n > FITS]


def stated():
    speeds, rows = late_speeds(), read_csv(HERE / "rows.csv")
    gage = max(rows["rolling_ratio"])
    yield "Bit R, {:.0f} inserts", teeth()
    yield "the cones turn {:.2f} to {:.2f} times as fast", min(speeds), max(speeds)
    yield "and {:.0f} % slower than the gage rows", 100.0 * (1.0 - sum(speeds) / len(speeds) / gage)
