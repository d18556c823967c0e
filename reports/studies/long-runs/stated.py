"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

GIVEN = ["trimmed 140 mm above the bit", "the one that 99 % exceed"]


def triangles(row):
    return float(row["triangles at the end"].replace(" ", ""))


def stated():
    rows = read_rows(Path(__file__).parent / "runs.csv")
    trimmed = next(row for row in rows if "rock.trim" in row["case"])
    whole = next(row for row in rows if row["case"] == "`bit-b-steady`, 1 m")
    yield "bit B ends with {:.0f} of them instead of {:.0f}", triangles(trimmed), triangles(whole)
    yield "no run ends with a triangle below {:.1f}", min(float(row["worst, 1 % quality"].split(",")[0]) for row in rows)
