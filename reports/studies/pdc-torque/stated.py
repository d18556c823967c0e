"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
EXACT = "work of a turn over exact"
GIVEN = ["The number asked for is 0.2 %", "eps 100 MPa, zeta 0.8", "W d/(2 pi), the work of a turn over 2 pi", "work pi R^2 d eps", "pi R^2 d from 1.4 mm", "must be eps R^2 d/2 is",
         "at 120 rpm", "With edges of 0.5 mm", "at 1, 2.08 and 3 mm a revolution", "With the 1 mm and 1 ms", "of 1 mm a revolution by several blades",
         "the longest edge, 1.6, it", "default of 1.2 the error of bit C at 3 mm", "% at 1 mm to", "% at 0.5 mm instead", "The default is now 1.7"]


def percent(ratio):
    return 100.0 * abs(ratio - 1.0)


def stated():
    rows = read_rows(HERE / "torque.csv")
    now = [r for r in rows if r["section lead"] == "default"]
    fine, shipped = ([r for r in now if r["edges, mm"] == edge] for edge in (0.5, 1.0))
    yield "within {:.2f} % of the exact one", max(percent(r[EXACT]) for r in fine)
    yield ("{:.2f} to {:.2f} % too low", min(100.0 * (1.0 - r[EXACT]) for r in shipped), max(100.0 * (1.0 - r[EXACT]) for r in shipped))
    weights = [100.0 * (r[EXACT] - r["torque over exact"]) for r in fine]
    yield "lower by {:.1f} to {:.1f} %", min(weights), max(weights)
    yield ("removed volume is within {:.2f} % of pi R^2 d",
           max(percent(r["removed volume over exact"]) for r in now if r["edges, mm"] <= 1.4))
    former = {r["edges, mm"]: r for r in rows if r["section lead"] != "default"}
    yield "grows from {:.1f} % at 1 mm to {:.1f} % at 0.5 mm", percent(former[1.0][EXACT]), percent(former[0.5][EXACT])
