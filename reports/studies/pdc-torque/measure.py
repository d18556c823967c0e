#!/usr/bin/python3
"""Torque of bits A, B and C at a given advance per revolution, against eps R^2 d/2. Writes torque.csv beside itself in
some five minutes; requires a release build.

    measure.py
    measure.py --program PROGRAM     another build's tdbd
"""

import argparse
import csv
import math
import pathlib
import subprocess
import tempfile

import numpy as np
import xarray

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
EDGES = (2.0, 1.4, 1.0, 0.7, 0.5)  # mm; the step is as many ms
ADVANCES = (1.0, 2.08, 3.0)  # mm a revolution
FORMER_LEAD = 1.2
RADIUS, EPS = 0.10795, 100e6  # m, Pa
REVOLUTIONS, TURN = 3, 0.5  # number, s
CASE = f'''
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
'''


def run(program, bit, advance, edge, more):
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.toml"
        rate = 1e-3 * advance / TURN * 3600
        case.write_text(CASE.replace("BIT", bit).replace("EDGE", str(edge)).replace("RATE", f"{rate:.6g}") + more, encoding="utf-8")
        result = subprocess.run([str(program), "run", str(case), "-o", f"{folder}/run", "--force"], capture_output=True, text=True,
                                check=False)
        if result.returncode != 0:
            raise SystemExit(result.stderr)
        with xarray.open_dataset(f"{folder}/run/history.nc") as history:
            return history.load()


def row(program, bit, advance, edge, lead=None):
    """Means of the last revolution. The force of a face opposes its motion on the helix, so that weight does a part of
    the work: eps R^2 d/2 is the work of a turn over 2 pi, torque + weight d/(2 pi)."""
    history = run(program, bit, advance, edge, f"[measure]\nsection_lead = {lead}\n" if lead else "")
    late = history.time.values > (REVOLUTIONS - 1) * TURN + 1e-9
    d = 1e-3 * advance
    exact = EPS * RADIUS**2 * d / 2
    torque, weight = (float(np.mean(history[name].values[late])) for name in ("torque_on_bit", "weight_on_bit"))
    removed = history.removed_volume_total.values[late]
    per_turn = (removed[-1] - removed[0]) * len(removed) / (len(removed) - 1)
    return {"bit": bit.upper(), "advance, mm": advance, "edges, mm": edge, "step, ms": edge, "section lead": lead or "default",
            "work of a turn over exact": (torque + weight * d / (2 * math.pi)) / exact, "torque over exact": torque / exact,
            "removed volume over exact": per_turn / (math.pi * RADIUS**2 * d)}


def write(name, rows):
    with open(HERE / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.5f}" if isinstance(v, float) and "over" in k else v for k, v in r.items()} for r in rows)


def main():
    parser = argparse.ArgumentParser(description="Torque of PDC bits against eps R^2 d/2.")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/tdbd")
    program = parser.parse_args().program
    rows = [row(program, bit, advance, edge) for bit in "abc" for advance in ADVANCES for edge in EDGES]
    rows += [row(program, "c", 3.0, edge, FORMER_LEAD) for edge in EDGES]
    write("torque.csv", rows)


if __name__ == "__main__":
    main()
