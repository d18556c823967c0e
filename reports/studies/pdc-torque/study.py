"""Torque of bits A, B and C at a given advance per revolution, against eps R^2 d/2."""

import math
from pathlib import Path

import numpy as np
from study_tools import ROOT, read_rows

EDGES = (2.0, 1.4, 1.0, 0.7, 0.5)  # mm; the step has the same value in ms
ADVANCES = (1.0, 2.08, 3.0)  # mm a revolution
FORMER_LEAD = 1.2
RADIUS, EPS = 0.10795, 100e6  # m, Pa
REVOLUTIONS, TURN = 3, 0.5  # number, s
CASE = f"""
[bit]
file = "{ROOT}/cases/bits/bit-BIT.toml"
[rock]
shape = "conforming"
edge_length = "EDGE mm"
wall = "30 mm"
material = "mancos-shale"
[motion]
kind = "steady"
rotary_speed = "120 rpm"
rate_of_penetration = "RATE m/h"
[time]
step = "EDGE ms"
revolutions = {REVOLUTIONS}
[forces]
law = "detournay"
eps = "100 MPa"
zeta = 0.8
[output]
history_every = 1
"""


def draw_bits(axes):
    from figures import style
    table = read_rows(Path(__file__).with_name("torque.csv")).where("section lead", "default")
    for bit, colour in {"A": style.BLUE, "B": style.RED, "C": style.GREY}.items():
        for advance, dash in zip(ADVANCES, ("solid", "dashed", "dotted")):
            rows = table.where("bit", bit, "advance, mm", advance)
            axes.plot(rows["edges, mm"], [100 * (w - 1) for w in rows["work of a turn over exact"]], "o", linestyle=dash, color=colour,
                      label=f"bit {bit}, {advance:g} mm")


def row(m, bit, advance, edge, lead=None):
    """Means of the last revolution. The force of a face opposes its motion on the helix, so that weight does a part of
    the work: eps R^2 d/2 is the work of a turn over 2 pi, torque + weight d/(2 pi)."""
    text = CASE.replace("BIT", bit).replace("EDGE", str(edge)).replace("RATE", f"{1e-3 * advance / TURN * 3600:.6g}")
    history = m.run(m.case(text), {"measure.section_lead": lead} if lead else {}).history
    late = history.time.values > (REVOLUTIONS - 1) * TURN + 1e-9
    d = 1e-3 * advance
    exact = EPS * RADIUS**2 * d / 2
    torque, weight = (float(np.mean(history[name].values[late])) for name in ("torque_on_bit", "weight_on_bit"))
    removed = history.removed_volume_total.values[late]
    per_turn = (removed[-1] - removed[0]) * len(removed) / (len(removed) - 1)
    found = {"work of a turn over exact": (torque + weight * d / (2 * math.pi)) / exact, "torque over exact": torque / exact,
             "removed volume over exact": per_turn / (math.pi * RADIUS**2 * d)}
    return {"bit": bit.upper(), "advance, mm": advance, "edges, mm": edge, "step, ms": edge, "section lead": lead or "default",
            **{name: f"{value:.5f}" for name, value in found.items()}}


def measure(m):
    runs = [(bit, advance, edge) for bit in "abc" for advance in ADVANCES for edge in EDGES]
    m.write("torque.csv", (row(m, *run) for run in runs + [("c", 3.0, edge, FORMER_LEAD) for edge in EDGES]))
