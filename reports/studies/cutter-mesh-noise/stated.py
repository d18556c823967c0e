"""The numbers of README.md, from the data of this study."""

import re
from pathlib import Path

from study_tools import read_rows

GIVEN = ["19 mm cutters, 120 rpm, 30 m/h, 1 ms", "A graded cutter of 64 corners", "a uniform one of 1 mm edges", "one of 256 corners", "a uniform one of 0.5 mm"]


def worst_bias(cell):
    """In percent, of a cell such as 0.27 % (1.52 %)."""
    found = re.search(r"\((.*) %\)", cell)
    return float(found[1]) if found else 0.0


def stated():
    by_name = {row["cutters"]: row for row in read_rows(Path(__file__).parent / "meshes.csv")}
    facets = {name: row["facets of a cutter"] for name, row in by_name.items()}
    yield "a bias of at most {:.1f} %", max(worst_bias(row["bias (worst), rock 1.5 mm"]) for row in by_name.values())
    yield "({:.0f} corners) for {:.2f} of its facets; one", by_name["uniform 1 mm"]["corners of the rim"], facets["graded 64"] / facets["uniform 1 mm"]
    yield "uniform one of 0.5 mm, for {:.2f} of its facets", facets["graded 256"] / facets["uniform 0.5 mm"]
