"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
FINEST, COARSEST = 0.4, 1.6  # mm
POINTED = ("ball", "cone", "wedge", "wedge yawed 37 deg", "milled tooth yawed 20 deg")
GIVEN = ["at edges of 0.8 mm had", "and bit R at 2 mm carried", "At 0.4 mm the drag", "At the coarsest mesh, 1.6 mm", "rate of 8 m/h from", "From edges of 2 mm to 1 mm its", "Halving the step at 1.4 mm",
         "under 100 kN turn", "falls from 0.5 to 0.25 over", "speed of 0.05 mm/s and a step of 0.5 ms", "With 1 mm/s the stick", "of 100 kN, and"]


def percent(ratio):
    return 100.0 * abs(ratio - 1.0)


def of_contacts():
    rows, orders = read_rows(HERE / "contacts.csv"), {r["contact"]: r for r in read_rows(HERE / "orders.csv")}
    fine = [r for r in rows if r["edges, mm"] == FINEST and not r["contact"].startswith("block")]
    yield ("all contacts but the tilted block is within\n{:.1f} % of the exact one, and their sliding weight within {:.1f} %",
           max(percent(r["drag"]) for r in fine), max(percent(r["weight"]) for r in fine))
    coarse = [r for r in rows if r["edges, mm"] == COARSEST and r["contact"] in POINTED]
    yield "wedge or milled tooth is {:.1f} %", max(percent(r[c]) for r in coarse for c in ("pressed weight", "weight", "drag"))
    block = orders["block tilted 12 deg"]
    yield ("tilted block is {:.1f} % low on the finest mesh, with an observed order of {:.1f}", percent(block["drag: at 0.4 mm"]),
           block["drag: order"])
    yield "drag of the milled tooth has an order of {:.1f}", orders["milled tooth yawed 20 deg"]["drag: order"]
    yield "weight of the sliding ball {:.1f}", orders["ball"]["weight: order"]


def of_bit_r():
    at = {(r["edges, mm"], r["step, ms"]): r for r in read_rows(HERE / "bit-r.csv")}
    for phrase, one, other in (("weight changes by\n{:.1f} % and its torque by {:.1f} %", (2.0, 1.0), (1.0, 1.0)),
                               ("changes them by {:.1f} % and {:.1f} %", (1.4, 1.0), (1.4, 0.5))):
        yield phrase, *(percent(at[one][c] / at[other][c]) for c in ("weight, kN", "torque, N m"))


def of_the_cycle():
    rows = read_rows(HERE / "cycle.csv")
    closed = next(r for r in rows if r["from"] == "closed form")
    found = {(float(r["weakening speed, mm/s"]), float(r["step, ms"])): r for r in rows if r["from"] == "TDBD"}
    sharp = found[0.05, 0.5]
    yield ("stick is {:.2f} % off the closed form, the slip {:.2f} %, the period {:.2f} % and the peak {:.2f} %",
           *(percent(float(sharp[c]) / float(closed[c])) for c in ("stick, s", "slip, s", "period, s", "peak over mean")))
    exact = next(r for r in rows if r["from"].startswith("one") and float(r["weakening speed, mm/s"]) == 1.0)
    yield "gives {:.3f} s, TDBD {:.3f} s", float(exact["stick, s"]), float(found[1.0, 0.25]["stick, s"])
    yield ("stays within {:.1f} N", 1e3 * max(max(100.0 - float(r["least weight, kN"]), float(r["most weight, kN"]) - 100.0)
                                             for r in found.values()))


def of_the_program_before():
    ball = {r["edges, mm"]: r for r in read_rows(HERE / "ball-before.csv")}
    before = {(r["edges, mm"], r["step, ms"]): r for r in read_rows(HERE / "bit-r-before.csv")}
    now = {(r["edges, mm"], r["step, ms"]): r for r in read_rows(HERE / "bit-r.csv")}
    yield ("A sliding ball\nat edges of 0.8 mm had {:.0f} % too little weight and {:.0f} % too little drag", percent(ball[0.8]["weight"]),
           percent(ball[0.8]["drag"]))
    yield ("bit R at 2 mm carried {:.1f} kN in\nplace of {:.1f} kN", before[2.0, 1.0]["weight, kN"], now[2.0, 1.0]["weight, kN"])


def stated():
    yield from of_contacts()
    yield from of_the_program_before()
    yield from of_bit_r()
    yield from of_the_cycle()
