#!/usr/bin/python3
"""How fast a whirling bit climbs, beside how fast a screw of its lean would: cases/drill-bit-b-whirl with strings that bend
ever more easily, and its advance over the time step. Writes climb.csv and steps.csv beside itself, two minutes; requires a
release build.

    measure.py
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import xarray

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "reports"))
from study_tools import write_rows  # noqa: E402

RING_RADIUS, RING_HEIGHT = 0.10795, 0.08  # m: gage radius of bit B, wall.ring_height
FROM = 0.5  # s: by then the bit rolls
# bending stiffness in N m/rad, its damping in N m s/rad, edges in mm
STRINGS = [("3e7", "3e5", "1.5"), ("3e7", "3e5", "3"), ("1e7", "1e5", "3"), ("2e6", "2e4", "3"), ("1e6", "1e4", "3"), ("1e6", "1e3", "3"),
           ("2e5", "1e3", "3")]
SHIPPED = {"string.bending_stiffness": "3e7", "string.bending_damping": "3e5", "motion.weight_on_bit": "10e3", "wall.slip_speed": "60e-3"}
CLIMBING = {"string.bending_stiffness": "1e7", "string.bending_damping": "1e5", "motion.weight_on_bit": "5e3", "wall.slip_speed": "1e-3"}
# the case of a row of steps.csv, its settings, edges in mm
CASES = [("shipped", SHIPPED, "1.5"), ("climbing", CLIMBING, "3")]
STEPS = [1, 0.5, 0.25, 0.125, 0.0625]  # ms


def drill(folder, settings, edges):
    """The history and the means of the second half second."""
    out = pathlib.Path(folder) / "run"
    settings = {**settings, "rock.edge_length": f"'{edges} mm'"}
    command = [str(ROOT / "build/release/tdbd"), "run", str(ROOT / "cases/drill-bit-b-whirl.toml"), "-o", str(out), "--force",
               *(word for key, value in settings.items() for word in ("--set", f"{key}={value}"))]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(result.stderr)
    with xarray.open_dataset(out / "history.nc") as history:
        return history.load(), json.loads((out / "summary.json").read_text(encoding="utf-8"))


def axes(history):
    """The bit's axis in space at every row: R e_z of the rotation vector."""
    vector = np.stack([history[f"rotation_vector_{x}"].values for x in "xyz"], 1)
    angle = np.linalg.norm(vector, axis=1, keepdims=True)
    n = vector / np.where(angle == 0.0, 1.0, angle)
    cosine = np.cos(angle)
    z = np.array([0.0, 0.0, 1.0])
    return cosine * z + np.sin(angle) * np.cross(n, z) + (1.0 - cosine) * n[:, 2:] * n


def climb(history):
    """Means since FROM: the climb, lean times travel of the touching point over the wall, and the difference: slip."""
    time, axis = history.time.values, axes(history)
    centre = np.stack([history[f"position_{x}"].values for x in "xyz"], 1) - RING_HEIGHT * axis
    e = np.hypot(centre[:, 0], centre[:, 1])
    around = np.gradient(np.unwrap(np.arctan2(centre[:, 1], centre[:, 0])), time)
    tangent = np.stack([-centre[:, 1], centre[:, 0]], 1) / np.maximum(e, 1e-12)[:, None]
    lean = np.sum(axis[:, :2] * tangent, 1)
    travel = around * (RING_RADIUS + e)
    late = time > FROM
    speed = -np.gradient(centre[:, 2], time)[late]
    screw = (lean * travel)[late]
    return {"climb, mm/s": f"{1e3 * speed.mean():.2f}", "lean times travel, mm/s": f"{1e3 * screw.mean():.2f}",
            "centre's circle, mm": f"{1e3 * e[late].mean():.2f}", "orbit, Hz": f"{around[late].mean() / (2.0 * np.pi):.1f}",
            "centre's speed, m/s": f"{np.mean(np.abs(around * e)[late]):.2f}", "travel, m/s": f"{travel[late].mean():.1f}",
            "lean, mrad": f"{1e3 * lean[late].mean():.3f}"}


def advance(history):
    """m/s since FROM, from the place at its beginning and end."""
    z, first = history.position_z.values, int(np.argmin(np.abs(history.time.values - FROM)))
    return (z[-1] - z[first]) / (history.time.values[-1] - history.time.values[first])


def value_of(summary, key):
    """The first value of this name anywhere in the summary."""
    for name, value in summary.items():
        if name == key:
            return value
        if isinstance(value, dict) and (found := value_of(value, key)) is not None:
            return found
    return None


def main():
    climbs, steps = [], []
    with tempfile.TemporaryDirectory() as folder:
        for stiffness, damping, edges in STRINGS:
            given = {"bending stiffness, N m/rad": stiffness, "damping, N m s/rad": damping, "edges, mm": edges}
            settings = {"string.bending_stiffness": stiffness, "string.bending_damping": damping}
            climbs.append({**given, **climb(drill(folder, settings, edges)[0])})
            print(climbs[-1], flush=True)
        for name, settings, edges in CASES:
            for step in STEPS:
                history, summary = drill(folder, {**settings, "time.step": step * 1e-3}, edges)
                steps.append({"case": name, "edges, mm": edges, "step, ms": step, "advance, mm/s": f"{1e3 * advance(history):.3f}",
                              "rop_mean, mm/s": f"{1e3 * value_of(summary, 'rop_mean_m_per_s'):.3f}",
                              "weight, kN": f"{1e-3 * value_of(summary, 'wob_mean_n'):.3f}"})
                print(steps[-1], flush=True)
    write_rows(HERE / "climb.csv", climbs)
    write_rows(HERE / "steps.csv", steps)


if __name__ == "__main__":
    main()
