"""The numbers of README.md, from the data of this study."""

from pathlib import Path
from statistics import median

from study_tools import read_rows

GIVEN = ["Bit B after 100 m", "12 turns that stand for 100 m, edges of 2 mm"]


def ratio(rows):
    return median(row["flat of TDBD, mm2"] / row["flat of Glowka's model, mm2"] for row in rows)


def largest(rows, name):
    return max(row[name] for row in rows)


def stated():
    rows = read_rows(Path(__file__).parent / "cutters.csv")
    medium, hard = ([row for row in rows if row["rock"] == rock] for rock in ("medium", "hard"))
    yield "{:.1f} times those of Glowka's model in the medium rock", ratio(medium)
    yield "and {:.1f} times in the hard rock", ratio(hard)
    for name, of in (("medium", medium), ("hard", hard)):
        text = "largest flat in the " + name + " rock has {:.1f} mm2 in TDBD and {:.1f} mm2 in the model"
        yield text, largest(of, "flat of TDBD, mm2"), largest(of, "flat of Glowka's model, mm2")
