"""The numbers of README.md, from the data of this study."""

import math
from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
UNDERCUT = 6.7, 50.0  # mm: radius of the half disc, its centre below the top
GIVEN = ["The thesis (2.1, fig. 2.1) says", "points at 1.4 mm edges", "(orbit of 3 mm, 14 Hz)", "of 0.2 mm cells",
         "with Langeveld's 120 spokes", "In whirl 240 spokes", "at the gage; 480 leave", "(12 spokes, 1 mm nodes:",
         "(half a disc of 6.7 mm, 50 mm below", "asks for its volume within 0.2 %"]


def errors(column):
    """{spokes: errors in mm}; of spokes that is Langeveld's and Hanson and Hansen's, of our mesh one."""
    table = read_csv(HERE / "errors.csv")
    return {spokes: [float(e) for e in str(cell).split(",")] for spokes, cell in zip(table["spokes"], table[column])}


def over_ours(column, spokes):
    """Hanson and Hansen's."""
    of = errors(column)
    return of[spokes][1] / of["our mesh"][0]


def most_gained():
    """Our error over the least of spokes, steady, whole."""
    of = errors("steady, whole: Langeveld, Hanson and Hansen")
    return of["our mesh"][0] / min(e for spokes, both in of.items() if spokes != "our mesh" for e in both)


def above_over_undercut(radius, below):
    """Area above an undercut and of itself, over its own."""
    own = math.pi * radius**2 / 2.0
    return (radius * below + own / 2.0) / own


def stated():
    at, wall = read_csv(HERE / "radius.csv"), read_csv(HERE / "volume.csv")
    [within], [removed], [respaced] = wall.values()
    axis, *_, gage = at["Langeveld"]
    yield "the error grows {:.1f} times from the axis to the gage and is {:.1f} times ours", gage / axis, gage / at["mesh"][-1]
    yield "better than a mesh, by up to {:.1f} times", most_gained()
    yield ("have {:.2f} of our error over the whole bottom and {:.2f} of it at the gage",
           over_ours("whirl, whole", "240"), over_ours("whirl, gage", "240"))
    yield "within the scalloped wall to {:.2f} %", 100.0 * abs((removed - respaced) / within - 1.0)
    yield "1 mm nodes: {:.2f} % of it", 100.0 * -respaced / within
    yield "they lose {:.2f} times its volume", above_over_undercut(*UNDERCUT)
