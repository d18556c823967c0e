"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_csv, read_rows

HERE = Path(__file__).parent
SHIPPED, FIFTEENTH, TENTH, OTHER = (3e7, 3e5), (2e6, 2e4), (1e6, 1e3), (1e6, 1e4)  # bending stiffness in N m/rad, damping in N m s/rad
WEIGHT = 10.0  # kN
GIVEN = ["Pushed by 10 kN", "1e6 N m/rad a tenth", "The shipped 60 mm/s is 0.2 % of", "default of 1 mm/s", "until 2026-11-26", "1e8 N m/rad and 1e6 N m s/rad at 5 and 10 kN (0.2 mm/s", "at steps of 0.25 ms and less", "off at 0.5 ms",
         "off at 1 ms", "22 mm nearer", "found -2.71 and -2.712 mm/s", "at its 0.5 ms is", "than at 0.0625 ms", "on 3 mm it", "from 1 ms to 0.0625 ms"]


def rows():
    """{(stiffness, damping): rows as {column: value}}, finest edges first."""
    climb, found = read_csv(HERE / "climb.csv"), {}
    for values in zip(*climb.values()):
        row = dict(zip(climb, values))
        found.setdefault((row["bending stiffness, N m/rad"], row["damping, N m s/rad"]), []).append(row)
    return found


def stated():
    found = rows()
    shipped, coarse = found[SHIPPED]
    [other], [tenth], [fifteenth] = found[OTHER], found[TENTH], found[FIFTEENTH]
    steps = {(r["case"], r["step, ms"]): r for r in read_rows(HERE / "steps.csv")}
    limit = steps["climbing", 0.0625]["advance, mm/s"]
    yield "travels at {:.0f} m/s where the centre goes around at {:.1f} m/s", -shipped["travel, m/s"], shipped["centre's speed, m/s"]
    yield "so that the {:.3f} mrad", -shipped["lean, mrad"]
    yield "leans lift it at {:.1f} mm/s", shipped["lean times travel, mm/s"]
    yield "advances by {:.1f} mm/s", -shipped["climb, mm/s"]
    yield "The wall bears {:.1f} kN", WEIGHT - steps["shipped", 0.5]["weight, kN"]
    yield "leans {:.0f} times as far", fifteenth["lean, mrad"] / coarse["lean, mrad"]
    yield "out of its hole by {:.1f} mm/s", fifteenth["climb, mm/s"]
    yield "makes it climb at {:.0f} mm/s instead of {:.0f}", tenth["climb, mm/s"], other["climb, mm/s"]
    yield "climbing bit is {:.2f} mm/s at", steps["climbing", 0.25]["advance, mm/s"]
    yield "it is {:.1f} % off", 100.0 * (steps["climbing", 0.5]["advance, mm/s"] / limit - 1.0)
    yield "0.5 ms and {:.1f} % off", 100.0 * (steps["climbing", 1.0]["advance, mm/s"] / limit - 1.0)
    yield "0.5 ms is {:.1f} % more", 100.0 * (steps["shipped", 0.5]["advance, mm/s"] / steps["shipped", 0.0625]["advance, mm/s"] - 1.0)
    yield "it is {:.2f} mm/s. **Known", -coarse["climb, mm/s"]
