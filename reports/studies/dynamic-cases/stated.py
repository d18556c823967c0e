"""The numbers of README.md, from the data of this study."""

import math
from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["with a factor of 2, and over", "root of 2", "is about 1 (",
         "shipped step of 0.5 ms", "and 0.0625 ms", "set to 30 kN", "set to 60 kN"]


def of_before(now):
    """Advance and reported rate of the whirling bit, mm/s, at the shipped and at the finest step; weight of bit B, kN."""
    before = {(r["case"], r["quantity"]): r for r in read_rows(HERE / "before.csv")}

    def ends(r):
        return 1e3 * float(r["value"]), 1e3 * float(r["by_step"].split()[-1])

    present = "drill-bit-b-whirl, present settings"
    yield "advanced by {:.1f} and {:.1f} mm/s and", *ends(before[present, "advance"])
    yield "reported {:.1f} and {:.1f} mm/s; it now", *ends(before[present, "rop_mean"])
    yield "it now advances by {:.1f} and {:.1f} mm/s", *ends(now["drill-bit-b-whirl", "rop_mean"])
    yield "advance changed its sign, from {:.1f} to {:.1f} mm/s, where", *ends(before["drill-bit-b-whirl", "advance"])
    yield "where {:.1f} and {:.1f} mm/s were reported", *ends(before["drill-bit-b-whirl", "rop_mean"])
    weights = (1e-3 * float(table[case, "wob_mean"]["value"]) for table in (before, now) for case in ("drill-bit-b", "stick-slip"))
    yield "were {:.2f} and {:.2f} kN and are {:.2f} and {:.2f} kN", *weights
    for phrase, which in (("by {:.2f} % to the finest step ({:.2f} % before)", "by_step"), ("and {:.2f} % to the finest edges ({:.2f} %)", "by_edge")):
        both = (now["high-frequency", "rop_mean"], before["high-frequency", "advance"])
        yield phrase, *(100.0 * abs(float(r[which].split()[-1]) / float(r["value"]) - 1.0) for r in both)


def of_sections():
    """By how much the two measures of sections differ with the longest and the shortest edges (mm), per cent."""
    rows = {(r["section_at_face"], float(r["edge_length_mm"])): r for r in read_rows(HERE / "sections.csv")}

    def difference(edge, quantity):
        return 100.0 * abs(float(rows["extrapolated", edge][quantity]) / float(rows["as_ahead", edge][quantity]) - 1.0)

    edges = [edge for _, edge in rows]
    for edge, phrase in ((max(edges), "At {:.1f} mm they differ by {:.0f} % in severity and {:.0f} % in frequency"),
                         (min(edges), "at {:.1f} mm by {:.0f} % and {:.0f} %. The")):
        yield phrase, edge, difference(edge, "stick_slip_severity"), difference(edge, "torsional_frequency_hz")


def stated():
    rows = {(r["case"], r["quantity"]): r for r in read_rows(HERE / "cases.csv")}

    def share(quantity):
        r = rows["drill-bit-b-whirl-rock", quantity]
        return 100.0 * float(r["uncertainty_edge"]) / abs(float(r["value"]))

    slip = rows["stick-slip", "rotary_speed_mean"]
    speed, of_top = float(slip["value"]), 2.0 * math.pi
    yield ("upper bound, {:.0f} % for a mean speed that differs from the top's by {:.2f} %",
           100.0 * float(slip["uncertainty_sampling"]) / speed, 100.0 * abs(speed / of_top - 1.0))
    yield "torque to {:.0f} %, frequency to {:.0f} %", share("tob_mean"), share("orbit_frequency")
    yield from of_sections()
    yield from of_before(rows)
