"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from readme_rows import largest_excess

GIVEN = ["8.5 in, 28 cutters", "at 120 rpm and advances 15 m/h in steps of 1 ms", "at edges of 1.0 mm", "1 when it is equilateral"]


def stated():
    yield "every revolution is within {:.2f} % of pi R^2 d", largest_excess(Path(__file__).parent)
