"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["with a factor of 2, and over", "root of 2", "is about 1 ("]


def stated():
    rows = {(r["case"], r["quantity"]): r for r in read_rows(HERE / "cases.csv")}

    def share(quantity):
        r = rows["drill-bit-b-whirl-rock", quantity]
        return 100.0 * float(r["uncertainty_edge"]) / abs(float(r["value"]))

    yield "torque to {:.0f} %, frequency to {:.0f} %", share("tob_mean"), share("orbit_frequency")
