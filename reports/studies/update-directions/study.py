"""Results of each rule for the update direction, as tables. Figures 4.7 to 4.9 of the thesis compare the rules (eq. 4.2) for PDC bits;
`gage_teeth` is their counterpart for roller cone bits.

What folds depends on the time step, and on what heals: with inside cutters along -X bit B has intersecting pairs after a third of a
revolution without maintenance of shapes, and none with it (directions_test).
"""

import math
import subprocess
import tomllib

from study_runs import set_words
from study_tools import ROOT

EDGE = 3e-3  # m
# bit: case, key of the rule, rules, settings, revolutions
BITS = {
    "bit-b": ("bit-b-steady", "update.directions", ["hybrid", "all-down", "along-profile"],
              {"motion.rate_of_penetration": "60 m/h", "time.step": "5 ms"}, 9),
    "bit-b inside": ("bit-b-steady", "update.inside_cutters", ["down", "minus-x", "plus-x"], {"time.step": "1 ms"}, 0.34),
    "bit-r": ("bit-r-steady", "update.gage_teeth", ["normal", "row", "down", "horizontal"], {"rock.wall": "60 mm", "time.step": "3 ms"}, 8),
}


def row(m, bit, rule):
    """A run that fails has a surface and an error message, but no summary."""
    from study_runs import read_run
    case, key, _, settings, turns = BITS[bit]
    out = m.temporary / "rule"
    words = set_words({"rock.edge_length": EDGE, key: rule, **settings, "time.revolutions": turns})
    subprocess.run([m.tdbd, "run", ROOT / f"cases/{case}.toml", "-o", out, "--force", "--quiet", *words], check=False, capture_output=True)
    found = {"bit": bit, "rule": rule, "revolutions": "", "last_revolution_over_pi_R2_d": "", "triangles_end_over_start": "",
             "intersecting_pairs": m.intersecting_pairs(out / "rock_final.ply"), "quality_min": "", "quality_1_percent": "",
             "maintenance_over_removed": "", "stopped": ""}
    if (out / "failure.txt").is_file():
        return found | {"stopped": (out / "failure.txt").read_text().strip()}
    s, motion = read_run(out).summary, tomllib.loads((out / "case.toml").read_text())["motion"]
    full, advance = int(s["revolutions"] + 1e-9), 2.0 * math.pi / motion["rotary_speed"] * motion["rate_of_penetration"]
    disc = math.pi * s["gage_radius_m"] ** 2 * advance
    numbers = {"revolutions": s["revolutions"], "triangles_end_over_start": s["rock_triangles_end"] / s["rock_triangles_start"],
               "quality_min": s["rock_quality_min"], "quality_1_percent": s["rock_quality_1_percent"],
               "maintenance_over_removed": s["maintenance_volume_m3"] / s["removed_volume_m3"]}
    if full:
        numbers["last_revolution_over_pi_R2_d"] = s["removed_volume_by_revolution_m3"][full - 1] / disc
    return found | {name: f"{number:.4g}" for name, number in numbers.items()}


def measure(m):
    m.write("meshes.csv", (row(m, bit, rule) for bit, (_, _, rules, *_) in BITS.items() for rule in rules))
