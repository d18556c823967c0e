#!/usr/bin/python3
"""Swing of hook load, weight and advance of bit R on its drill string over rotary speed: cases/string-roller-resonance.toml.

    measure.py [--tdbd PROGRAM] [--results FOLDER]

Writes speeds.csv and modes.csv beside itself. Runs that are complete in FOLDER are not repeated. Requires a release build.
"""

import argparse
import json
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(HERE.parents[1]))
import system_python  # noqa: E402

system_python.require("numpy", "xarray", "netCDF4")

import numpy as np  # noqa: E402
import xarray  # noqa: E402
from study_tools import write_rows  # noqa: E402

CASE = ROOT / "cases/string-roller-resonance.toml"
SPEEDS, EDGE = (42, 54, 60, 66, 72, 78, 90, 110, 130, 150), 4.0  # rpm, mm
RESONANCE, FINER = 130, 2.8  # rpm; mm, of one more run there
EVEN = """rock.layers=[{top = "0 mm", material = "berea-sandstone"}]"""  # without the boundary
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


def modes(tdbd, folder):
    """Axial frequencies of the string with its bit free, Hz."""
    sections = tomllib.loads(CASE.read_text(encoding="utf-8"))["string"]["sections"]
    text = "\n".join("[[string.sections]]\n" + "\n".join(f"{k} = {json.dumps(v)}" for k, v in s.items()) for s in sections)
    case = folder / "string.toml"
    case.write_text(STRING.format(mass=BIT_MASS, inertia=BIT_INERTIA, sections=text), encoding="utf-8")
    subprocess.run([tdbd, "string", case, "-o", folder / "string", "--force", "--quiet"], check=True)
    found = json.loads((folder / "string/summary.json").read_text(encoding="utf-8"))
    return [{"mode": k, "axial_hz": round(f, 5)} for k, f in enumerate(found["axial_frequencies_hz"], 1)]


def line_at(time, values, frequency):
    """Complex amplitude of the values' part at a frequency, by least squares under a Hann window."""
    window = np.hanning(len(time))
    basis = np.stack([np.ones_like(time), time - time.mean(), np.cos(2.0 * np.pi * frequency * time), np.sin(2.0 * np.pi * frequency * time)])
    fit = np.linalg.lstsq((basis * window).T, values * window, rcond=None)[0]
    return complex(fit[2], -fit[3])


def end_stiffness(frequency):
    """Force over displacement at the lower end of the rods of the case, with the bit's mass, N/m: closed form."""
    w, below = 2.0 * np.pi * frequency, None
    for section in tomllib.loads(CASE.read_text(encoding="utf-8"))["string"]["sections"]:
        length, outer, inner = (float(section[key].split()[0]) * (1.0 if key == "length" else 1e-3) for key in ("length", "outer_diameter", "inner_diameter"))
        z = np.pi / 4.0 * (outer**2 - inner**2) * np.sqrt(YOUNG * DENSITY) * w  # N/m
        tangent = np.tan(w * length / np.sqrt(YOUNG / DENSITY))
        below = z / tangent if below is None else z * (below - z * tangent) / (z + below * tangent)
    return below - BIT_MASS * w**2


def measured(tdbd, folder, rpm, edge, rock):
    """Swings at one speed; rock: boundary, as the case has it, or even."""
    out = folder / f"{rock}-{rpm}-{edge}"
    if not (out / "summary.json").is_file():
        given = {"motion.rotary_speed": f"'{rpm} rpm'", "rock.edge_length": f"'{edge} mm'", "time.duration": f"'{DURATION} s'"}
        words = [w for k, v in given.items() for w in ("--set", f"{k}={v}")] + (["--set", EVEN] if rock == "even" else [])
        subprocess.run([tdbd, "run", CASE, "-o", out, "--force", "--quiet", *words], check=True, stderr=subprocess.DEVNULL)
    with xarray.open_dataset(out / "history.nc", decode_times=False) as data:
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tdbd", default=ROOT / "build/release/tdbd")
    parser.add_argument("--results", type=Path, default=ROOT / "results/roller-resonance")
    given = parser.parse_args()
    given.results.mkdir(parents=True, exist_ok=True)
    write_rows(HERE / "modes.csv", modes(given.tdbd, given.results))
    rows = []
    plan = [*((rpm, EDGE, "boundary") for rpm in SPEEDS), (RESONANCE, EDGE, "even"), (RESONANCE, FINER, "boundary")]
    for place in plan:
        rows.append(measured(given.tdbd, given.results, *place))
        print(rows[-1], flush=True)
        write_rows(HERE / "speeds.csv", sorted(rows, key=lambda r: (r["rock"], -r["edge_mm"], r["rpm"])))


if __name__ == "__main__":
    main()
