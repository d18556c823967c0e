"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["1.25 times the difference", "that sum at most 2 % of the", "pressed down at 62 mm/s and 8 rad/s",
         "is 11 % smaller than", "with edges of 0.25 mm", "differs by 1.8 % in its", "and by 1.2 % in its turn", "runs with edges of 0.5 mm, not",
         "The bodies bear 0.6 % of the", "50 ms after its start", "together 22 % too large", "with edges of 1 mm",
         "speed was 21.3 rad/s with edges of", "0.5 mm, that of the twin 22.6", "agree within 0.4 % beyond",
         "may be 5 %"]


def stated():
    rows = {(r["situation"], r["quantity"]): {k: float(v) for k, v in r.items() if k not in ("situation", "quantity")}
            for r in read_rows(HERE / "coupled-twin.csv")}

    def combined(r):
        return r["uncertainty"] + r["uncertainty of the twin"]

    rolling = rows["rolls on flat rock", "turn of the bit"]
    yield "its rolling cone differs by {:.1e} rad", abs(rolling["difference"])
    turn = rows["bit b sticks and slips", "turn"]
    yield "first swing of stick-slip differs by {:.1f} %; the sum", 100.0 * abs(turn["difference"]) / turn["twin"]
    yield "the uncertainties is {:.1f} %, so", 100.0 * combined(turn) / turn["twin"]
