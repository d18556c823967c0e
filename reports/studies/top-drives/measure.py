#!/usr/bin/python3
"""Stick-slip of cases/string-stick-slip.toml under three top drives, and its convergence in time step and edge length.

    measure.py [--tdbd PROGRAM] [--results FOLDER]

Writes runs.csv, torque.csv, simple.csv, traces.csv and reflection.csv beside itself. Runs that are complete in FOLDER are not repeated.
Nine minutes of one quiet core; requires a release build.
"""

import argparse
import json
import math
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

INERTIA, FREQUENCY = 2900.0, 0.234  # kg m2 of a top drive; Hz, the string's first torsional vibration
FACTOR, COMPENSATION, SMALL_INTEGRAL = 4.0, 0.95, 100.0  # soft torque; z-torque
OUTER, INNER, SHEAR, DENSITY = 0.127, 0.1086, 79.3e9, 7850.0  # m, Pa, kg/m3: the pipe
TOPS = {
    "stiff": {},
    "soft-torque": {"string.top.torsion": "'soft-torque'", "string.top.inertia": f"'{INERTIA} kg m2'",
                    "string.top.impedance_factor": FACTOR, "string.top.tuned_frequency": f"'{FREQUENCY} Hz'"},
    "z-torque": {"string.top.torsion": "'z-torque'", "string.top.inertia": f"'{INERTIA} kg m2'",
                 "string.top.compensation": COMPENSATION, "string.top.integral": f"'{SMALL_INTEGRAL} N m/rad'"},
}
SPEEDS = (75, 60)  # rpm
SHIPPED_STEP, SHIPPED_EDGE, COARSE_EDGE, DURATION = 1.0, 2.0, 4.0, 40.0  # ms, mm, s; the second speed is run with coarse edges
CONVERGENCE = [(1.0, 4.0), (0.5, 4.0), (1.0, 2.8)]  # ms, mm; stiff top, beside the shipped run
SHORTER = 28.0  # s of these runs
SETTLED = 15.0  # s: what is before is the transient of the start
MUD = (0.1, 0.0)  # 1/s: of the runs, and none
BIT = (38.49, 0.13518)  # kg, kg m2: bit B
RANGES = (0.2, 1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 21.0)  # rad/s
ROW = 0.05  # s between rows of traces.csv


def plan():
    """(top, rpm, step in ms, edges in mm, duration in s) of all runs."""
    runs = [(top, rpm, SHIPPED_STEP, edge, DURATION) for rpm, edge in zip(SPEEDS, (SHIPPED_EDGE, COARSE_EDGE)) for top in TOPS]
    return runs + [("stiff", SPEEDS[0], step, edge, SHORTER) for step, edge in CONVERGENCE]


def settings(top, rpm, step, edge, duration):
    return TOPS[top] | {"motion.rotary_speed": f"'{rpm} rpm'", "time.step": f"'{step} ms'", "time.duration": f"'{duration} s'",
                        "rock.edge_length": f"'{edge} mm'"}


def run(tdbd, folder, asked):
    """A run, unless the folder has it with the same settings. Returns the processor time when it ran, s."""
    stamp, wanted = folder / "settings.json", json.dumps(asked)
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == wanted:
        return
    words = [word for key, value in asked.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([tdbd, "run", ROOT / "cases/string-stick-slip.toml", "-o", folder, "--force", "--quiet", *words], check=True)
    stamp.write_text(wanted, encoding="utf-8")


def period(time, speed):
    """Mean time between rises from below 0.7 to above 1.3 times the mean speed. Blank where there are less than two."""
    low, rises = False, []
    for t, share in zip(time, speed / speed.mean()):
        if low and share > 1.3:
            rises.append(t)
        low = share < 0.7 or (low and share <= 1.3)
    return round(float(np.diff(rises).mean()), 4) if len(rises) > 1 else ""


def figures(folder, top, rpm, step, edge):
    """What the settled part of a run shows."""
    with xarray.open_dataset(folder / "history.nc", decode_times=False) as data:
        time = data["time"].values
        late = time >= SETTLED
        speed, surface, torque, weight = (data[name].values[late] for name in
                                          ("rotary_speed", "surface_torque", "torque_on_bit", "weight_on_bit"))
    time, mean = time[late], speed.mean()
    stuck = speed < 0.05 * mean
    moves = np.flatnonzero(stuck[:-1] & ~stuck[1:])
    breakaway = [torque[max(i - 100, 0):i + 1].max() for i in moves if stuck[max(i - 50, 0):i].all()]
    return {"top": top, "rpm": rpm, "step_ms": step, "edge_mm": edge, "severity": round((speed.max() - speed.min()) / (2.0 * mean), 4),
            "stuck_share": round(float(stuck.mean()), 4), "period_s": period(time, speed),
            "least_rpm": round(speed.min() * 30.0 / math.pi, 2), "most_rpm": round(speed.max() * 30.0 / math.pi, 2),
            "surface_torque_swing_n_m": round(float(np.ptp(surface)), 1), "surface_torque_mean_n_m": round(float(surface.mean()), 1),
            "torque_mean_n_m": round(float(torque.mean()), 1), "torque_turning_n_m": round(float(torque[speed > mean].mean()), 1),
            "breakaway_n_m": round(float(np.mean(breakaway)), 1) if breakaway else "",
            "weight_swing_n": round(float(np.ptp(weight)), 1)}


def torque_over_speed(folder):
    """Mean torque on the bit in ranges of its speed, apart for rising and falling speed."""
    with xarray.open_dataset(folder / "history.nc", decode_times=False) as data:
        late = data["time"].values >= SETTLED
        speed, torque = (data[name].values[late] for name in ("rotary_speed", "torque_on_bit"))
    rises, rows = np.gradient(speed) > 0.0, []
    for low, high in zip(RANGES, RANGES[1:]):
        within = (speed >= low) & (speed < high)
        rows.append({"from_rad_s": low, "to_rad_s": high, "rising_n_m": round(float(torque[within & rises].mean()), 1),
                     "falling_n_m": round(float(torque[within & ~rises].mean()), 1)})
    return rows


def simple(tdbd, folder, levels, mud):
    """The same string on a bit of two levels of torque, N m, released from rest; with a damping of the mud, 1/s."""
    folder.mkdir(parents=True, exist_ok=True)
    string = tomllib.loads((ROOT / "cases/string-stick-slip.toml").read_text(encoding="utf-8"))["string"]
    plain = lambda table: "\n".join(f"{key} = {json.dumps(value)}" for key, value in table.items())
    text = ["[string]", 'model = "chain"', 'start = "rest"', f"mass = {BIT[0]}", f"torsional_inertia = {BIT[1]}"]
    text += ["[[string.sections]]\n" + plain(section) for section in string["sections"]]
    text += ["[string.friction]", plain(string["friction"]), f"torsional_damping = {mud}"]
    text += ["[string.bit]", 'law = "two-level"', f"static = {levels[0]}", f"dynamic = {levels[1]}"]
    text += ["[motion]", f'rotary_speed = "{SPEEDS[0]} rpm"', f"torque_at_start = {levels[0] - 5.0}"]
    text += ["[time]", f'step = "{SHIPPED_STEP} ms"', f'duration = "{DURATION} s"']
    (folder / "case.toml").write_text("\n".join(text), encoding="utf-8")
    subprocess.run([tdbd, "string", folder / "case.toml", "-o", folder / "out", "--force", "--quiet"], check=True)
    with xarray.open_dataset(folder / "out/history.nc", decode_times=False) as data:
        late = data["time"].values >= SETTLED
        time, speed, surface = (data[name].values[late] for name in ("time", "speed", "surface_torque"))
    stuck = speed < 0.05 * speed.mean()
    return {"static_n_m": levels[0], "dynamic_n_m": levels[1], "mud_per_s": mud,
            "severity": round((speed.max() - speed.min()) / (2.0 * speed.mean()), 4), "stuck_share": round(float(stuck.mean()), 4),
            "period_s": period(time, speed), "most_rpm": round(speed.max() * 30.0 / math.pi, 2),
            "surface_torque_swing_n_m": round(float(np.ptp(surface)), 1)}


def reflection(kind, frequency):
    """Of waves of speed in the pipe at the top: (Z - Zt)/(Z + Zt), magnitude."""
    polar = math.pi / 32.0 * (OUTER**4 - INNER**4)
    z = polar * math.sqrt(SHEAR * DENSITY)
    s = 2j * math.pi * frequency
    if kind == "stiff":
        return 1.0
    if kind == "soft-torque":
        zt = INERTIA * s + FACTOR * z + INERTIA * (2.0 * math.pi * FREQUENCY) ** 2 / s
    else:
        zt = (1.0 - COMPENSATION) * INERTIA * s + z + SMALL_INTEGRAL / s
    return abs((z - zt) / (z + zt))


def traces(folders):
    """Rows of ROW seconds of the runs at the first speed: speeds in rpm, torque at the surface in kN m."""
    columns = {}
    for top, folder in folders.items():
        with xarray.open_dataset(folder / "history.nc", decode_times=False) as data:
            time = np.arange(ROW, DURATION + 0.5 * ROW, ROW)
            columns["time_s"] = np.round(time, 3)
            for name, key, scale in (("bit_rpm", "rotary_speed", 30.0 / math.pi), ("top_rpm", "top_speed", 30.0 / math.pi),
                                     ("surface_torque_kn_m", "surface_torque", 1e-3), ("torque_kn_m", "torque_on_bit", 1e-3)):
                columns[f"{top}_{name}"] = np.round(np.interp(time, data["time"].values, scale * data[key].values), 3)
    return [dict(zip(columns, map(float, row))) for row in zip(*columns.values())]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tdbd", default=ROOT / "build/release/tdbd")
    parser.add_argument("--results", type=Path, default=ROOT / "results/top-drives")
    given = parser.parse_args()
    rows, shown = [], {}
    for top, rpm, step, edge, duration in plan():
        folder = given.results / f"{top}-{rpm}-{step}-{edge}"
        run(given.tdbd, folder, settings(top, rpm, step, edge, duration))
        rows.append(figures(folder, top, rpm, step, edge))
        print(rows[-1], flush=True)
        if rpm == SPEEDS[0] and len(shown) < len(TOPS):
            shown[top] = folder
    write_rows(HERE / "runs.csv", rows)
    write_rows(HERE / "torque.csv", torque_over_speed(shown["stiff"]))
    levels = (rows[0]["breakaway_n_m"], rows[0]["torque_turning_n_m"])
    write_rows(HERE / "simple.csv", [simple(given.tdbd, given.results / f"simple-{mud}", levels, mud) for mud in MUD])
    write_rows(HERE / "traces.csv", traces(shown))
    of_cycle = round(1.0 / rows[0]["period_s"], 4)
    frequencies = sorted({of_cycle, FREQUENCY} | {round(float(f), 4) for f in np.geomspace(0.05, 3.0, 121)})
    write_rows(HERE / "reflection.csv", [{"frequency_hz": f} | {kind: round(reflection(kind, f), 5) for kind in TOPS} for f in frequencies])


if __name__ == "__main__":
    main()
