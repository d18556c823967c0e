"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

GIVEN = ['("and smoothing below 0.5")', "every 20 steps does as well", "only below 0.3 h", "collapsing below 0.5 h, or bisecting above 1.4 h"]
WITHOUT_FLIPS = ("smoothing without flips", "neither")


def worst(row):
    """Of a triangle in bit R's rock and in the core's."""
    return [float(row[column].split(",")[0]) for column in ("bit R: worst, 1 % quality", "core: worst, 1 % quality")]


def stated():
    rows = {row["choice"]: row for row in read_rows(Path(__file__).parent / "choices.csv")}
    yield "leaves triangles of {:.2f} and less", max(quality for name in WITHOUT_FLIPS for quality in worst(rows[name]))
