"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
GIVEN = ["Bit B turns 2.5 times", "rock of 40 MPa", "by 0.8 times the strength", "with 1.5 times the strength", "The two share no code", "At 4 mm a revolution",
         "at 14 mm it is", "At 12 mm the body", "with edges of 4 mm", "with 2 mm and", "with 1 mm: contacts", "with edges of 2 mm a run", "at 9 mm the body carries"]


def at(table, key, place, by="depth_of_cut_mm"):
    """The value of a table of runs at a place."""
    return dict(zip(table[by], table[key], strict=True))[place]


def between(table, key, depth):
    """The radial plane's value at a depth of cut, linear between its rows."""
    depths, values = table["depth_of_cut_mm"], table[key]
    k = next(i for i, d in enumerate(depths) if d >= depth)
    w = (depth - depths[k - 1]) / (depths[k] - depths[k - 1])
    return values[k - 1] + w * (values[k] - values[k - 1])


def stated():
    plan, runs, edges = (read_csv(HERE / f"{name}.csv") for name in ("plan", "runs", "edges"))
    yield "the body touches at {:.1f} mm a revolution", 0.5 * plan["depth_of_cut_mm"][-1]
    yield "of the run is {:.2f} times", at(runs, "weight_n", 4.0) / between(plan, "weight_n", 4.0)
    yield "at 14 mm it is {:.2f} times", at(runs, "weight_n", 14.0) / between(plan, "weight_n", 14.0)
    yield "of the plane carries {:.1f} kN", 1e-3 * between(plan, "body_weight_n", 12.0)
    by_edge = [1e-3 * at(edges, "body_weight_n", e, "edge_mm") for e in (4.0, 2.0, 1.0)]
    yield "In the run it carries {:.1f} kN with edges of 4 mm, {:.1f} kN with 2 mm and {:.1f} kN with 1 mm", *by_edge
    yield "the body carries {:.1f} kN of the plane's {:.1f} kN", 1e-3 * at(runs, "body_weight_n", 9.0), 1e-3 * between(plan, "body_weight_n", 9.0)
