"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["1.25 times the difference", "that sum at most 2 % of the", "edges of 1 mm", "by 10 % at the", "by 3 % after 0.2 s", "by less than 0.1 %",
         "bears 0.6 % of its weight", "agree and are below 2 %", "at most 40 facets", "energy agree within 0.6 %",
         "differ by 2.4 % and 0.8 %"]


def stated():
    rows = {(r["situation"], r["quantity"]): {k: float(v) for k, v in r.items() if k not in ("situation", "quantity")}
            for r in read_rows(HERE / "coupled-twin.csv")}

    def combined(r):
        return r["uncertainty"] + r["uncertainty of the twin"]

    bounce = [rows["bounces from tooth to tooth", q] for q in ("weight", "energy spent on the rock")]
    fastest, turn = (rows["bit b sticks and slips", q] for q in ("fastest", "turn"))
    yield "are {:.1f} % and {:.1f} %: its balls", *(100.0 * combined(r) / r["twin"] for r in bounce)
    yield "program is {:.1f} rad/s and that of the twin {:.1f},", fastest["program"], fastest["twin"]
    yield "turns {:.1f} % less", -100.0 * turn["difference"] / turn["twin"]
    yield "uncertainties are {:.1f} rad/s and {:.1f} %", combined(fastest), 100.0 * combined(turn) / turn["twin"]
