#!/usr/bin/python3
"""How a bit stands: the shipped stick-slip, and the same bit not turned, at several edges and steps. Writes sticks.csv,
plunges.csv and case.csv beside itself, two minutes; wants a release build.

    measure.py
    measure.py --program PROGRAM --explicit     another build's tdbd: that of before, explicit in every step
"""

import argparse
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

EDGES, STEPS = (3.0, 2.0), (3.0, 2.0, 1.0, 0.5)  # mm, ms
STICK, QUIET = 0.5, 0.04  # rad/s, s: the bit is stuck where it turns slower for so long on both sides
FALLEN = 1.0  # s: by then faces and bodies bear a bit that is not turned
STICKS = {"time.duration": "6 s"}
PLUNGE = {"time.duration": "3 s", "motion.rotary_speed": "0 rpm", "motion.torque_at_start": 0}
WHOLE = {"time.duration": "20 s"}


def drill(program, folder, settings):
    out = pathlib.Path(folder) / "run"
    command = [str(program), "run", str(ROOT / "cases/stick-slip.toml"), "-o", str(out), "--force"]
    for key, value in {**settings, "measure.section_at_face": "as_ahead", "output.history_every": 1}.items():  # a row for each step
        command += ["--set", f"{key}={value!r}"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(result.stderr)
    with xarray.open_dataset(out / "history.nc") as history:
        return history.load(), json.loads((out / "summary.json").read_text(encoding="utf-8"))


def with_mesh(settings, edges, step):
    return {**settings, "rock.edge_length": f"{edges} mm", "time.step": f"{step} ms"}


def stuck_steps(history, step):
    """Steps at which the bit is stuck, and was one step before."""
    moves = np.abs(history.rotary_speed.values) >= STICK
    reach = round(QUIET / step)
    near = np.convolve(moves, np.ones(2 * reach + 1), "same") > 0
    return ~near[1:] & ~near[:-1]


def figures(history, step, chosen):
    """rms of a step's change of the weight over the weight, creep in mm/s."""
    weight, z = history.weight_on_bit.values, history.position_z.values
    change = np.diff(weight)[chosen] / np.mean(weight[1:][chosen])
    return np.sqrt(np.mean(change**2)), 1e3 * np.mean(np.diff(z)[chosen]) / step


def sticks(program, folder, edges, step):
    history, summary = drill(program, folder, with_mesh(STICKS, edges, step))
    change, creep = figures(history, step * 1e-3, stuck_steps(history, step * 1e-3))
    return {"edges, mm": edges, "step, ms": step, "change of weight": f"{change:.1e}", "creep, mm/s": f"{creep:.3f}",
            "depth at 6 s, mm": f"{1e3 * history.position_z.values[-1]:.2f}",
            "residual of energy, J": f"{history.energy_residual.values[-1]:.4f}", **searches(summary)}


def plunges(program, folder, edges, step):
    """From the first second on: until then the bit falls into the rock."""
    history, summary = drill(program, folder, with_mesh(PLUNGE, edges, step))
    late = history.time.values[1:] > FALLEN
    change, creep = figures(history, step * 1e-3, late)
    return {"edges, mm": edges, "step, ms": step, "change of weight": f"{change:.1e}", "creep, mm/s": f"{creep:.3f}",
            "depth at 1 s, mm": f"{1e3 * np.interp(FALLEN, history.time.values, history.position_z.values):.2f}",
            "depth at 3 s, mm": f"{1e3 * history.position_z.values[-1]:.2f}", **searches(summary)}


def searches(summary):
    standing = summary.get("standing", {"steps": 0, "unsettled": 0, "most_rounds": 0})
    return {"steps solved": standing["steps"], "unsettled": standing["unsettled"], "most rounds": standing["most_rounds"]}


def whole_case(program, folder, name):
    _, summary = drill(program, folder, WHOLE)
    seen = summary["diagnosis"]
    return {"program": name, "rate of penetration, mm/s": f"{1e3 * summary['rop_mean_m_per_s']:.3f}",
            "stuck share": f"{seen['stuck_share']:.3f}", "frequency, Hz": f"{seen['torsional_frequency_hz']:.3f}",
            "severity": f"{seen['stick_slip_severity']:.2f}"}


def main():
    parser = argparse.ArgumentParser(description="How a bit stands.")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/tdbd")
    parser.add_argument("--explicit", action="store_true", help="writes the files of the program before")
    arguments = parser.parse_args()
    end = "-before.csv" if arguments.explicit else ".csv"
    levels = [(edges, step) for edges in EDGES for step in STEPS]
    with tempfile.TemporaryDirectory() as folder:
        write_rows(HERE / f"sticks{end}", [sticks(arguments.program, folder, *level) for level in levels])
        write_rows(HERE / f"plunges{end}", [plunges(arguments.program, folder, *level) for level in levels])
        write_rows(HERE / f"case{end}", [whole_case(arguments.program, folder, "explicit" if arguments.explicit else "now")])


if __name__ == "__main__":
    main()
