"""The numbers of README.md, from the data of this study and from benchmarks/measured.json."""

import math
from pathlib import Path

from benchmark_figures import measured
from study_tools import read_csv

HERE = Path(__file__).parent
EQUAL_ERROR = ("rivals", "warm", "standard-0.7-volumes", "mean_over_z_map")
GIVEN = ["Langeveld's 120 of 500 nodes", "our surface at t = 0", "those within 3 mm of its tip",
         "2 < r < 106 mm, against a height field of 0.1 mm cells",
         "Asked at 1.0 mm: 0.02 / 0.06 mm", "our 0.7 mm stand beside cells of 0.5 mm", "comes within 0.05 % of", "% at 1.0 mm: the mesh"]


def order(edges, errors):
    """By least squares of the logarithms."""
    x, y = [math.log(e) for e in edges], [math.log(e) for e in errors]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def farthest(revolutions, edge):
    """Of the second to the fourth revolution, percent of the exact volume."""
    row = revolutions["edges, mm"].index(edge)
    return max(abs(revolutions[name][row]) for name in ("second, %", "third, %", "fourth, %"))


def stated():
    [wall] = next(iter(read_csv(HERE / "wall.csv").values()))
    revolutions = read_csv(HERE / "revolutions.csv")
    yield "takes {:.2f} times the height field's in the mean, {:.2f} times before", measured(*EQUAL_ERROR), measured("before", *EQUAL_ERROR)
    yield "is {:.3f} % below", -wall
    yield "in the edge length is {:.1f} by least", order(revolutions["edges, mm"], revolutions["rms, %"])
    yield "with either sign, by up to {:.3f} % at 1.0 mm", farthest(revolutions, 1.0)
