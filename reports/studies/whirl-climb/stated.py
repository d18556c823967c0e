"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv

SHIPPED, FIFTH, TENTH = (1e7, 1e5), (2e6, 2e4), (1e6, 1e3)  # bending stiffness in N m/rad, damping in N m s/rad
GIVEN = ["pushed by 5 kN", "with 1e6 N m/rad a tenth"]


def rows():
    """{(stiffness, damping): rows as {column: value}}, finest edges first."""
    climb, found = read_csv(Path(__file__).parent / "climb.csv"), {}
    for values in zip(*climb.values()):
        row = dict(zip(climb, values))
        found.setdefault((row["bending stiffness, N m/rad"], row["damping, N m s/rad"]), []).append(row)
    return found


def stated():
    found = rows()
    shipped, drills = found[SHIPPED][0], [-row["climb, mm/s"] for row in found[SHIPPED]]
    [fifth], [tenth], [other] = found[FIFTH], found[TENTH], found[1e6, 1e4]
    same_edges = found[SHIPPED][-1]
    yield "travels at {:.0f} m/s where the centre goes around at {:.1f} m/s", -shipped["travel, m/s"], shipped["centre's speed, m/s"]
    yield "so that {:.1f} mrad lift the bit at {:.0f} mm/s", -shipped["lean, mrad"], shipped["lean times travel, mm/s"]
    yield "and drills {:.1f} to {:.1f} mm/s", min(drills), max(drills)
    yield ("it leans {:.1f} times as far and climbs {:.0f} mm/s out of its hole, {:.0f} mm/s less",
           fifth["lean, mrad"] / same_edges["lean, mrad"], fifth["climb, mm/s"], fifth["lean times travel, mm/s"] - fifth["climb, mm/s"])
    yield "makes it climb at {:.0f} mm/s instead of {:.0f}", tenth["climb, mm/s"], other["climb, mm/s"]
