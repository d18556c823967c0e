"""The numbers of README.md, from the data of this study."""

from pathlib import Path
from statistics import median

from study_tools import read_rows

GIVEN = ["The volume with 3 mm", "with 2 mm, is no better", "Bit B after 100 m", "12 turns that stand for 100 m, edges of 2 mm"]


def ratio(rows):
    return median(row["flat of TDBD, mm2"] / row["flat of Glowka's model, mm2"] for row in rows)


def largest(rows, name):
    return max(row[name] for row in rows)


def stated():
    rows = read_rows(Path(__file__).parent / "cutters.csv")
    medium, hard = ([row for row in rows if row["rock"] == rock] for rock in ("medium", "hard"))
    yield "{:.1f} times those of Glowka's model in the medium rock", ratio(medium)
    yield "and {:.1f} times in the hard rock", ratio(hard)
    worn = {(row["law"], row["key"], row["value"]): row["worn volume, mm3"] for row in read_rows(Path(__file__).parent / "convergence.csv")}
    edges = "thermal", "rock.edge_length"
    yield "it is {:.1f} mm3 with the shipped", worn[*edges, "3 mm"]
    yield "edges of {:.0f} mm and", 3.0
    yield "and {:.1f} mm3 with {:.2f} mm, and", worn[*edges, "1.05 mm"], 1.05
    yield "factor of at least {:.1f}, and", worn[*edges, "1.05 mm"] / worn[*edges, "3 mm"]
    yield "smaller: {:.1f} mm3 with a quarter", worn["thermal", "time.step", "0.5 ms"]
    yield "time step, {:.1f} mm3 with a quarter", worn["thermal", "wear.largest_growth", "0.00125"]
    yield "{:.1f} mm3 with half of the acceleration", worn["thermal", "wear.acceleration", "3000"]
    yield "the same volume, {:.1f} mm3", worn["sliding", "rock.edge_length", "3 mm"]
    for name, of in (("medium", medium), ("hard", hard)):
        text = "largest flat in the " + name + " rock has {:.1f} mm2 in TDBD and {:.1f} mm2 in the model"
        yield text, largest(of, "flat of TDBD, mm2"), largest(of, "flat of Glowka's model, mm2")
