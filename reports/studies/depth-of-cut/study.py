"""Weight of bit B over depths of cut and edge lengths, by runs and by the radial plane of `tdbd bit --report`."""

import json

from study_tools import ROOT

TURNS_PER_S = 2.0  # 120 rpm
DEPTHS = (4.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0)  # mm/rev
EDGES, DEEP = (4.0, 2.8, 2.0, 1.4, 1.0), 12.0  # mm; mm/rev
STRENGTH = 40e6  # Pa, of a rock without confinement
CASE = """[bit]
file = "{bit}"
[rock]
shape = "conforming"
edge_length = "{edge} mm"
wall = "30 mm"
[rock.material]
name = "any"
unconfined_strength = "{strength} MPa"
friction_angle = "30 deg"
[motion]
kind = "steady"
rotary_speed = "120 rpm"
rate_of_penetration = {rate}
[time]
step = "1 ms"
revolutions = 2.5
[forces]
law = "detournay"
eps = "{strength} MPa"
zeta = 0.8
sigma = 0
mu = 0
l = 0
"""


def row(m, depth, edge):
    """The weight, and the part that the body carries: the difference from a run without forces on the body, which moves no rock."""
    text = CASE.format(bit=ROOT / "cases/bits/bit-b.toml", edge=edge, strength=STRENGTH / 1e6, rate=1e-3 * depth * TURNS_PER_S)
    whole, alone = (m.run(m.case(text + more)).summary["wob_mean_n"] for more in ("", '[forces.bit_body]\nlaw = "none"\n'))
    return {"depth_of_cut_mm": depth, "edge_mm": edge, "body_weight_n": round(whole - alone, 3), "weight_n": round(whole, 3)}


def measure(m):
    m.output("tdbd", "bit", ROOT / "cases/bits/bit-b.toml", "-o", m.temporary / "bit", "--report", "--quiet")
    curve = json.loads((m.temporary / "bit/analysis.json").read_text())["body"]["weight_over_depth_of_cut"]
    m.write("plan.csv", ({"depth_of_cut_mm": round(1e3 * d, 6), "body_weight_n": round(1.5 * STRENGTH * a, 3), "weight_n": round(STRENGTH * w, 3)}
                         for d, a, w in zip(curve["depth_of_cut_m_per_rev"], curve["rubbing_area_m2"], curve["weight_over_strength_m2"], strict=True)))
    m.write("runs.csv", (row(m, depth, 2.0) for depth in DEPTHS))
    m.write("edges.csv", (row(m, DEEP, edge) for edge in EDGES))
