"""Runs bit B over depths of cut and edge lengths, and writes runs.csv, edges.csv and plan.csv. Minutes on one core.

    reports/studies/depth-of-cut/measure.py [--tdbd PROGRAM]
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import write_rows  # noqa: E402

TURNS_PER_S = 2.0  # 120 rpm
DEPTHS = (4.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0)  # mm/rev
EDGES = (4.0, 2.8, 2.0, 1.4, 1.0)  # mm, at DEEP
DEEP = 12.0  # mm/rev
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


def weight(tdbd, folder, depth, edge, more=""):
    """Mean of the second half, N."""
    case = Path(folder) / "case.toml"
    case.write_text(CASE.format(bit=ROOT / "cases/bits/bit-b.toml", edge=edge, strength=STRENGTH / 1e6, rate=1e-3 * depth * TURNS_PER_S) + more)
    subprocess.run([tdbd, "run", case, "-o", Path(folder) / "out", "--force", "--quiet"], check=True, stderr=subprocess.DEVNULL)
    return json.loads((Path(folder) / "out/summary.json").read_text())["wob_mean_n"]


def run(tdbd, folder, depth, edge):
    """The weight, and what the body carries of it: the body moves no rock, so that the rest is the same without its force."""
    all_of_it = weight(tdbd, folder, depth, edge)
    alone = weight(tdbd, folder, depth, edge, '[forces.bit_body]\nlaw = "none"\n')
    print(depth, edge, all_of_it, all_of_it - alone, flush=True)
    return {"depth_of_cut_mm": depth, "edge_mm": edge, "body_weight_n": round(all_of_it - alone, 3), "weight_n": round(all_of_it, 3)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tdbd", default=ROOT / "build/release/tdbd")
    tdbd = parser.parse_args().tdbd
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([tdbd, "bit", ROOT / "cases/bits/bit-b.toml", "-o", Path(folder) / "bit", "--report", "--quiet"], check=True)
        body = json.loads((Path(folder) / "bit/analysis.json").read_text())["body"]
        curve = body["weight_over_depth_of_cut"]
        write_rows(HERE / "plan.csv", [{"depth_of_cut_mm": round(1e3 * d, 6), "body_weight_n": round(1.5 * STRENGTH * a, 3),
                                        "weight_n": round(STRENGTH * w, 3)}
                                       for d, a, w in zip(curve["depth_of_cut_m_per_rev"], curve["rubbing_area_m2"],
                                                          curve["weight_over_strength_m2"], strict=True)])
        write_rows(HERE / "runs.csv", [run(tdbd, folder, depth, 2.0) for depth in DEPTHS])
        write_rows(HERE / "edges.csv", [run(tdbd, folder, DEEP, edge) for edge in EDGES])


if __name__ == "__main__":
    main()
