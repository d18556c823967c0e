#!/usr/bin/python3
"""Maps of stick-slip of bit B on 2500 m of drill string, over weight and rotary speed: the 3-D bit, and a regenerative bit without a shape.

    measure.py [--tdbd PROGRAM] [--results FOLDER] [--threads N]

Writes beside itself: forces.csv (forces of the bit at given depths of cut), map.csv (cases/sweeps/stability-map.toml), simple.csv
(the simple bit at the same points) and levels.csv (some points of the map with other edges and steps). A killed run continues where
it was. Requires a release build; README.md has its duration.
"""

import argparse
import json
import subprocess
import sys
import time as clock
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(HERE.parents[1]))
import system_python  # noqa: E402

system_python.require("numpy", "xarray", "netCDF4")

import numpy as np  # noqa: E402
import xarray  # noqa: E402
from study_tools import read_rows, write_rows  # noqa: E402

DESIGN = ROOT / "cases/sweeps/stability-map.toml"
CASE = ROOT / "cases/string-stick-slip.toml"
BLADES, BIT_MASS, BIT_INERTIA = 5, 38.49, 0.13518  # of bit B: kg, kg m2
DEPTHS, SPEEDS = (2.0, 5.0, 8.0, 11.0), (40.0, 80.0, 140.0)  # mm a turn at the middle speed; rpm at the middle depth
FIGURES = {"diagnosis.stick_slip_severity": "severity", "diagnosis.stuck_share": "stuck_share", "diagnosis.wob_swing": "weight_swing",
           "diagnosis.lost_contact_share": "lost_contact_share", "rop_mean_m_per_s": "rate_mm_s", "rotary_speed_mean_rad_per_s": "speed_rad_s",
           "wob_mean_n": "weight_n", "tob_mean_n_m": "torque_n_m"}
POINTS = ((80, 70), (80, 130))  # kN, rpm: of levels.csv
LEVELS = ((5.0, 2.0), (3.5, 2.0), (5.0, 1.0))  # edges in mm, steps in ms; the first is the map's
PRESCRIBED = """[bit]
file = "{bit}"
[rock]
shape = "conforming"
edge_length = "2 mm"
wall = "30 mm"
material = "berea-sandstone"
[motion]
kind = "steady"
rotary_speed = "{rpm} rpm"
rate_of_penetration = {rate}
[time]
step = "{step} ms"
revolutions = 2
[forces]
{law}
"""
SIMPLE = """[string]
model = "chain"
mass = {mass}
torsional_inertia = {inertia}
{sections}
[string.friction]
{friction}
[string.top]
{top}
[string.bit]
law = "regenerative"
axial_stiffness = {k}
torsional_stiffness = {t}
contact_force = {w0}
contact_lever = {lever}
pitch = "{pitch} deg"
axial_damping = "2e5 N s/m"
[motion]
rotary_speed = "{rpm} rpm"
rate_of_penetration = {rate}
weight_at_start = "{weight} kN"
torque_at_start = "{torque}"
[time]
step = "1 ms"
duration = "{duration} s"
"""


def lines(table):
    """A table of keys with plain values as TOML."""
    return "\n".join(f"{key} = {json.dumps(value)}" for key, value in table.items())


def seconds(text):
    return float(str(text).split()[0])


def prescribed(tdbd, folder, depth, rpm):
    """Weight and torque at a given advance, mm a turn, and rotary speed."""
    folder.mkdir(parents=True, exist_ok=True)
    law = lines(tomllib.loads(CASE.read_text(encoding="utf-8"))["forces"])
    case = folder / f"{depth:g}-{rpm:g}.toml"
    case.write_text(PRESCRIBED.format(bit=ROOT / "cases/bits/bit-b.toml", rpm=rpm, rate=1e-3 * depth * rpm / 60.0, step=80.0 / rpm, law=law),
                    encoding="utf-8")
    subprocess.run([tdbd, "run", case, "-o", case.with_suffix(""), "--force", "--quiet"], check=True)
    summary = json.loads((case.with_suffix("") / "summary.json").read_text(encoding="utf-8"))
    return {"depth_mm": depth, "rpm": rpm, "weight_n": round(summary["wob_mean_n"], 2), "torque_n_m": round(summary["tob_mean_n_m"], 3)}


def forces(tdbd, folder):
    runs = [(depth, SPEEDS[1]) for depth in DEPTHS] + [(DEPTHS[1], rpm) for rpm in SPEEDS if rpm != SPEEDS[1]]
    return [prescribed(tdbd, folder, depth, rpm) for depth, rpm in runs]


def linear(rows):
    """Weight w0 + k d and torque t0 + t d over the depth of cut d of all blades: N, N/m, N m, N."""
    at_middle = [r for r in rows if float(r["rpm"]) == SPEEDS[1]]
    depth = np.array([1e-3 * float(r["depth_mm"]) for r in at_middle])
    k, w0 = np.polyfit(depth, [float(r["weight_n"]) for r in at_middle], 1)
    t, t0 = np.polyfit(depth, [float(r["torque_n_m"]) for r in at_middle], 1)
    return w0, k, t0, t


def sweep(tdbd, folder, threads):
    """The map of the 3-D bit, from the shipped design."""
    table = folder / "map.nc"
    subprocess.run([tdbd, "sweep", DESIGN, "-o", table, "--threads", str(threads), "--quiet"], check=True)
    with xarray.open_dataset(table, decode_times=False) as data:
        columns = {name: data[name].values for name in ("motion.weight_at_start", "motion.rotary_speed", *FIGURES)}
    rows = []
    for i in range(len(columns["motion.rotary_speed"])):
        row = {"weight_kn": seconds(columns["motion.weight_at_start"][i]), "rpm": seconds(columns["motion.rotary_speed"][i])}
        rows.append(row | {name: round(float(columns[key][i]) * (1e3 if name == "rate_mm_s" else 1.0), 5) for key, name in FIGURES.items()})
    return rows


def simple_case(design, shipped, line, weight, rpm):
    """The case of tdbd string whose bit cuts as the 3-D bit does, without its shape."""
    w0, k, t0, t = line
    string = shipped["string"]
    sections = "\n".join(f"[[string.sections]]\n{lines(s)}" for s in string["sections"])
    rate = max(1e3 * weight - w0, 0.0) / k * rpm / 60.0
    return SIMPLE.format(mass=BIT_MASS, inertia=BIT_INERTIA, sections=sections, friction=lines(string["friction"]), top=lines(string["top"]),
                         k=BLADES * k, t=BLADES * t, w0=w0, lever=t0 / w0, pitch=360.0 / BLADES, rpm=rpm, rate=rate, weight=weight, torque=design["set"]["motion"]["torque_at_start"],
                         duration=seconds(design["set"]["time"]["duration"]))


def simple(tdbd, folder, line, weight, rpm):
    """The simple bit at one point; measured as the diagnosis of a run measures."""
    folder.mkdir(parents=True, exist_ok=True)
    design, shipped = (tomllib.loads(path.read_text(encoding="utf-8")) for path in (DESIGN, CASE))
    case = folder / f"{weight:g}-{rpm:g}.toml"
    case.write_text(simple_case(design, shipped, line, weight, rpm), encoding="utf-8")
    subprocess.run([tdbd, "string", case, "-o", case.with_suffix(""), "--force", "--quiet"], check=True)
    with xarray.open_dataset(case.with_suffix("") / "history.nc", decode_times=False) as data:
        late = data["time"].values >= seconds(design["set"]["output"]["means_from"])
        time, speed, load, place = (data[name].values[late] for name in ("time", "speed", "weight", "displacement"))
    mean = speed.mean()
    return {"weight_kn": weight, "rpm": rpm, "severity": round((speed.max() - speed.min()) / (2.0 * mean), 5) if mean > 0.0 else "nan",
            "stuck_share": round(float((speed <= 0.05 * mean).mean()), 5),
            "weight_swing": round(float(np.ptp(load) / (2.0 * load.mean())), 5), "lost_contact_share": round(float((load <= 0.0).mean()), 5),
            "rate_mm_s": round(1e3 * (place[-1] - place[0]) / (time[-1] - time[0]), 5), "speed_rad_s": round(float(mean), 5)}


def level(tdbd, folder, point, edge, step):
    """A point of the map with other edges and another step."""
    weight, rpm = point
    out = folder / f"{weight}-{rpm}-{edge}-{step}"
    if not (out / "summary.json").is_file():
        given = {f"{table}.{key}": value for table, keys in tomllib.loads(DESIGN.read_text(encoding="utf-8"))["set"].items() for key, value in keys.items()}
        given |= {"motion.weight_at_start": f"{weight} kN", "motion.rotary_speed": f"{rpm} rpm", "rock.edge_length": f"{edge} mm", "time.step": f"{step} ms"}
        words = [w for key, value in given.items() for w in ("--set", f"{key}={json.dumps(value)}")]
        subprocess.run([tdbd, "run", CASE, "-o", out, "--force", "--quiet", *words], check=True)
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    d = summary["diagnosis"]
    return {"weight_kn": weight, "rpm": rpm, "edge_mm": edge, "step_ms": step, "severity": round(d["stick_slip_severity"], 4),
            "stuck_share": round(d["stuck_share"], 4), "weight_swing": round(d["wob_swing"], 4), "rate_mm_s": round(1e3 * summary["rop_mean_m_per_s"], 4)}


def level_of(rows, point):
    """The point as the map has it."""
    row = next(r for r in rows if (r["weight_kn"], r["rpm"]) == point)
    return {"weight_kn": point[0], "rpm": point[1], "edge_mm": LEVELS[0][0], "step_ms": LEVELS[0][1],
            **{key: round(row[key], 4) for key in ("severity", "stuck_share", "weight_swing", "rate_mm_s")}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tdbd", default=ROOT / "build/release/tdbd")
    parser.add_argument("--results", type=Path, default=ROOT / "results/stability-map")
    parser.add_argument("--threads", type=int, default=2)
    given = parser.parse_args()
    given.results.mkdir(parents=True, exist_ok=True)
    began = clock.monotonic()
    if not (HERE / "forces.csv").is_file():
        write_rows(HERE / "forces.csv", forces(given.tdbd, given.results / "forces"))
    line = linear(read_rows(HERE / "forces.csv"))
    print(f"weight {line[0]:.0f} N + {line[1]:.4g} N/m d, torque {line[2]:.1f} N m + {line[3]:.4g} N d", flush=True)
    rows = sweep(given.tdbd, given.results, given.threads)
    write_rows(HERE / "map.csv", rows)
    print(f"map: {clock.monotonic() - began:.0f} s", flush=True)
    write_rows(HERE / "simple.csv", [simple(given.tdbd, given.results / "simple", line, r["weight_kn"], r["rpm"]) for r in rows])
    write_rows(HERE / "levels.csv", [level_of(rows, p) if size == LEVELS[0] else level(given.tdbd, given.results / "levels", p, *size)
                                     for p in POINTS for size in LEVELS])
    print(f"all: {clock.monotonic() - began:.0f} s", flush=True)


if __name__ == "__main__":
    main()
