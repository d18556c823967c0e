"""Swing of hook load, weight and advance of bit R on its drill string over rotary speed: cases/string-roller-resonance.toml."""

import json
import tomllib
from pathlib import Path

import numpy as np
from study_tools import ROOT, read_rows

CASE = ROOT / "cases/string-roller-resonance.toml"
SPEEDS, EDGE = (42, 54, 60, 66, 72, 78, 90, 110, 130, 150), 4.0  # rpm, mm
RESONANCE, FINER = 130, 2.8  # rpm; mm, of one more run there
EVEN = ["--set", 'rock.layers=[{top = "0 mm", material = "berea-sandstone"}]']  # without the boundary
SETTLED, DURATION = 1.5, 3.5  # s
YOUNG, DENSITY = 206e9, 7850.0  # Pa, kg/m3: steel
CONES, BIT_MASS, BIT_INERTIA = 3, 31.62, 0.11834  # kg, kg m2: bit R
STRING = """[string]
model = "chain"
mass = {mass}
torsional_inertia = {inertia}
element_length = "5 m"
{sections}
[string.friction]
mud_density = "1200 kg/m3"
[motion]
rotary_speed = "72 rpm"
"""


def draw_swing(axes, key, scale, color):
    from figures import style
    rows = read_rows(Path(__file__).with_name("speeds.csv"))
    boundary = rows.where("rock", "boundary", "edge_mm", EDGE)
    axes.plot(boundary["excitation_hz"], [scale * v for v in boundary[key]], "o-", color=color, label="on the boundary")
    for form, name, chosen in (("s", "finer edges", [r for r in rows if r["edge_mm"] != EDGE]), ("x", "without the boundary", rows.where("rock", "even"))):
        axes.plot([r["excitation_hz"] for r in chosen], [scale * r[key] for r in chosen], form, color=style.BLACK, label=name)


def sections_of_case():
    return tomllib.loads(CASE.read_text(encoding="utf-8"))["string"]["sections"]


def modes_of(m):
    """Axial frequencies of the string with a free bit, Hz."""
    text = "\n".join("[[string.sections]]\n" + "\n".join(f"{k} = {json.dumps(v)}" for k, v in s.items()) for s in sections_of_case())
    run = m.run(m.case(STRING.format(mass=BIT_MASS, inertia=BIT_INERTIA, sections=text)), command="string")
    return [{"mode": k, "axial_hz": round(f, 5)} for k, f in enumerate(run.summary["axial_frequencies_hz"], 1)]


def line_at(time, values, frequency):
    """Complex amplitude of the values' part at a frequency, by least squares under a Hann window."""
    window, w = np.hanning(len(time)), 2.0 * np.pi * frequency
    basis = np.stack([np.ones_like(time), time - time.mean(), np.cos(w * time), np.sin(w * time)])
    fit = np.linalg.lstsq((basis * window).T, values * window, rcond=None)[0]
    return complex(fit[2], -fit[3])


def end_stiffness(frequency):
    """Force over displacement at the lower end of the rods of the case, with the bit's mass, N/m: closed form."""
    w, below = 2.0 * np.pi * frequency, None
    for section in sections_of_case():
        length, outer, inner = (float(section[key].split()[0]) * (1.0 if key == "length" else 1e-3) for key in ("length", "outer_diameter", "inner_diameter"))
        z = np.pi / 4.0 * (outer**2 - inner**2) * np.sqrt(YOUNG * DENSITY) * w  # N/m
        tangent = np.tan(w * length / np.sqrt(YOUNG / DENSITY))
        below = z / tangent if below is None else z * (below - z * tangent) / (z + below * tangent)
    return below - BIT_MASS * w**2


def row(m, rpm, edge, rock):
    """Oscillations at one speed. `rock`: "boundary" (that of the case) or "even" (homogeneous)."""
    settings = {"motion.rotary_speed": f"{rpm} rpm", "rock.edge_length": f"{edge} mm", "time.duration": f"{DURATION} s"}
    data = m.run(CASE, settings, words=EVEN if rock == "even" else []).history
    late = data["time"].values >= SETTLED
    time, hook, weight, rate = (data[name].values[late] for name in ("time", "hook_load", "weight_on_bit", "rate_of_penetration"))
    excited = CONES * rpm / 60.0
    moved = line_at(time, rate, excited) / (2j * np.pi * excited)
    pressed = line_at(time, weight, excited)
    return {"rock": rock, "rpm": rpm, "edge_mm": edge, "excitation_hz": round(excited, 3), "hook_load_std_n": round(float(hook.std()), 1),
            "hook_load_line_n": round(abs(line_at(time, hook, excited)), 1), "displacement_line_mm": round(1e3 * abs(moved), 5),
            "weight_std_n": round(float(weight.std()), 1), "weight_line_n": round(abs(pressed), 1),
            "weight_mean_n": round(float(weight.mean()), 1), "stiffness_kn_mm": round(-1e-6 * (pressed / moved).real, 4),
            "stiffness_of_rods_kn_mm": round(1e-6 * float(end_stiffness(excited)), 4)}


def measure(m):
    m.write("modes.csv", modes_of(m))
    plan = [*((rpm, EDGE, "boundary") for rpm in SPEEDS), (RESONANCE, EDGE, "even"), (RESONANCE, FINER, "boundary")]
    m.write("speeds.csv", sorted((row(m, *place) for place in plan), key=lambda r: (r["rock"], -r["edge_mm"], r["rpm"])))
