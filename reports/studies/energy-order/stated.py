"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

GIVEN = ["Edges of 3 mm, runs of 0.5 to 1 s", "window of 24 steps", "with h, h/2 and h/4"]
WHIRL = "drill-bit-b-whirl"


def stated():
    rows = [row for row in read_rows(Path(__file__).parent / "orders.csv") if row["observed order"] > 0.0]  # NaN where contact was lost
    off = max(abs(row["observed order"] - 2.0) for row in rows if row["case"] != WHIRL)
    whirl = [row["observed order"] for row in rows if row["case"] == WHIRL]
    yield "Second order, within {:.2f}", off
    yield "gives {:.1f} to {:.1f}", min(whirl), max(whirl)
