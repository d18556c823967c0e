#!/usr/bin/python3
"""Bit R at a prescribed rate over edges and steps, and a cycle of stick and slip on pads with Coulomb friction, against
its closed form. Writes bit-r.csv, cycle.csv and cycle-trace.csv beside itself in half an hour; requires a release build.

    measure_bits.py
    measure_bits.py --program PROGRAM     another build's tdbd
    measure_bits.py --program PROGRAM --bit-r bit-r-before.csv     only bit R, to this file
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import tempfile

import numpy as np
import xarray
from scipy.integrate import solve_ivp

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
LEVELS = ((2.8, 1.0), (2.0, 1.0), (1.4, 1.0), (1.0, 1.0), (2.0, 0.5), (1.4, 0.5))  # mm, ms
BIT_R = f'''
[bit]
file = "{ROOT}/cases/bits/bit-r.toml"
[rock]
shape = "conforming"
edge_length = "EDGE mm"
wall = "60 mm"
material = "mancos-shale"
pressure = "3000 psi"
[motion]
kind = "steady"
rotary_speed = "90 rpm"
rate_of_penetration = "8 m/h"
cone_speeds = "rolling"
[time]
step = "STEP ms"
revolutions = 1.5
[forces]
law = "indentation"
[output]
means_from = "0.666667 s"
'''

# Four pads at 80 mm under 100 kN on a torsional pendulum; friction falls from 0.5 to 0.25 over a weakening speed.
INERTIA, STIFFNESS, WEIGHT, ARM, MU, WEAKENING, SPEED = 288.6, 611.9, 1e5, 0.08, 0.5, 0.5, 2 * math.pi
STUCK = 1e-4  # of the rotary speed
CYCLE = '''
[bit]
file = "pads.toml"
[rock]
shape = "flat"
radius = "100 mm"
edge_length = "3 mm"
wall = "5 mm"
[rock.material]
unconfined_strength = "1000 MPa"
friction_angle = "30 deg"
[motion]
kind = "drilling"
rotary_speed = "60 rpm"
rate_of_penetration = "0 m/h"
weight_at_start = "100 kN"
torque_at_start = "6000 N m"
[string]
mass = "1e5 kg"
gravity = 0
torsional_inertia = "288.6 kg m2"
bending_inertia = "288.6 kg m2"
attachment_height = 0
lateral_stiffness = "1e8 N/m"
bending_stiffness = "1e8 N m/rad"
lateral_damping = "1e5 N s/m"
axial_stiffness = "1e10 N/m"
axial_damping = "1e5 N s/m"
bending_damping = "1e5 N m s/rad"
torsional_stiffness = "611.9 N m/rad"
[time]
step = "STEP ms"
duration = "13.5 s"
[forces]
law = "friction"
stress = "200 MPa"
cap = 100
mu = 0.5
weakening = 0.5
weakening_speed = "FALL mm/s"
full_angle = 0
[output]
history_every = 1
'''
PAD = """OFF
8 6 0
70 -10 -20
90 -10 -20
90 10 -20
70 10 -20
70 -10 0
90 -10 0
90 10 0
70 10 0
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


def run(program, folder, case):
    (folder / "case.toml").write_text(case, encoding="utf-8")
    result = subprocess.run([str(program), "run", str(folder / "case.toml"), "-o", str(folder / "run"), "--force"],
                            capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(result.stderr)
    with xarray.open_dataset(folder / "run" / "history.nc") as history:
        return history.load(), json.loads((folder / "run" / "summary.json").read_text(encoding="utf-8"))


def bit_r(program, edge, step):
    with tempfile.TemporaryDirectory() as folder:
        history, _ = run(program, pathlib.Path(folder), BIT_R.replace("EDGE", str(edge)).replace("STEP", str(step)))
    late = history.time.values > 2 / 3
    return {"edges, mm": edge, "step, ms": step, "weight, kN": 1e-3 * history.weight_on_bit.values[late].mean(),
            "torque, N m": history.torque_on_bit.values[late].mean()}


def pads(folder):
    (folder / "pad.off").write_text(PAD, encoding="utf-8")
    parts = "".join(f'[[parts]]\nname = "pad-{i}"\nkind = "gage-pad"\nfile = "pad.off"\nunit = "1 mm"\n'
                    f'rotation_vector = [0, 0, "{90 * i} deg"]\nupdate_direction = [0, 0, 1]\n' for i in range(4))
    (folder / "pads.toml").write_text('name = "pads"\n' + parts, encoding="utf-8")


def switches(time, speed):
    """Times at which the bit sticks, and at which it slips again."""
    stuck = np.abs(speed) < STUCK * SPEED
    change = np.flatnonzero(np.diff(stuck.astype(int))) + 1
    return [t for t, i in zip(time[change], change) if stuck[i]], [t for t, i in zip(time[change], change) if not stuck[i]]


def cycle(program, fall, step):
    """The second slip and the stick after it; history of the cycle."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        pads(folder)
        history, summary = run(program, folder, CYCLE.replace("STEP", str(step)).replace("FALL", str(fall)))
    time, speed = history.time.values, history.rotary_speed.values
    sticks, slips = switches(time, speed)
    row = {"weakening speed, mm/s": fall, "step, ms": step, "stick, s": slips[1] - sticks[1], "slip, s": sticks[1] - slips[0],
           "period, s": sticks[2] - sticks[1], "peak over mean": speed[time > slips[0]].max() / SPEED,
           "least weight, kN": 1e-3 * history.weight_on_bit.values[1:].min(),
           "most weight, kN": 1e-3 * history.weight_on_bit.values[1:].max(),
           "unsettled": summary["standing"]["unsettled"]}
    chosen = (time > slips[0] - 0.2) & (time < slips[1] + 0.2)
    return row, time[chosen] - slips[0], speed[chosen] / SPEED


def integrated(fall):
    """One rotational freedom with the same friction law, by an adaptive method: a cycle from breakaway to breakaway."""
    slide = 1e-3 * fall

    def friction(w):
        return WEIGHT * ARM * MU * (1 - WEAKENING * (1 - math.exp(-abs(w) * ARM / slide)))

    def rates(_, y):
        return [SPEED - y[1], (STIFFNESS * y[0] - friction(y[1])) / INERTIA]

    def stops(_, y):
        return y[1]

    def threshold(_, y):
        return y[1] - STUCK * SPEED

    stops.terminal, stops.direction = True, -1
    start = WEIGHT * ARM * MU / STIFFNESS
    solved = solve_ivp(rates, (0, 20), [start, 1e-12], events=[stops, threshold], rtol=1e-10, atol=1e-13, method="LSODA",
                       max_step=5e-3)
    end, twist = solved.t_events[0][0], solved.y_events[0][0][0]
    up, down = solved.t_events[1][:2]
    rest = (start - twist) / SPEED
    return {"stick, s": rest + up + end - down, "slip, s": down - up, "period, s": end + rest,
            "peak over mean": solved.y[1].max() / SPEED}


def closed_form():
    """Friction that falls at once, as the weakening speed goes to 0."""
    a = WEIGHT * ARM * MU * WEAKENING / STIFFNESS
    frequency = math.sqrt(STIFFNESS / INERTIA)
    stick, slip = 2 * a / SPEED, 2 / frequency * (math.pi - math.atan(a * frequency / SPEED))
    return {"stick, s": stick, "slip, s": slip, "period, s": stick + slip,
            "peak over mean": 1 + math.hypot(1, a * frequency / SPEED)}


def text_of(key, value):
    if not isinstance(value, float):
        return value
    return f"{value:g}" if key.startswith(("edges", "step", "weakening")) else f"{value:.4f}"


def write(name, rows):
    with open(HERE / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: text_of(k, v) for k, v in row.items()} for row in rows)


def cycles(program):
    rows = []
    for fall, steps in ((1.0, (1.0, 0.5, 0.25)), (0.05, (1.0, 0.5, 0.25))):
        for step in steps:
            row, time, speed = cycle(program, fall, step)
            rows.append({"from": "TDBD", **row})
            print(row, flush=True)
            if (fall, step) == (0.05, 0.5):
                write("cycle-trace.csv", [{"time, s": t, "speed over mean": w} for t, w in zip(time[::20], speed[::20])])
        rows.append({"from": "one freedom, adaptive", "weakening speed, mm/s": fall, **integrated(fall)})
    rows.append({"from": "closed form", "weakening speed, mm/s": 0.0, **closed_form()})
    columns = {key: "" for row in rows for key in row}
    write("cycle.csv", [columns | row for row in rows])


def main():
    parser = argparse.ArgumentParser(description="Bit R and a Coulomb cycle.")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/tdbd")
    parser.add_argument("--bit-r", metavar="NAME", help="measures only bit R, and writes it to this file beside the script")
    arguments = parser.parse_args()
    if not arguments.bit_r:
        cycles(arguments.program)
    rows = []
    for edge, step in LEVELS:
        rows.append(bit_r(arguments.program, edge, step))
        print(rows[-1], flush=True)
    write(arguments.bit_r or "bit-r.csv", rows)


if __name__ == "__main__":
    main()
