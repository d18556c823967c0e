#!/usr/bin/python3
"""measure.py [TDBD]: how fast the cones of bit R roll, by what they remember and by the step. Writes speeds.csv and fifty.csv beside itself.

TDBD: the program, of a release build unless another is named. A minute.
"""

import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import xarray

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
MEMORIES, STEPS = (0, 10, 32, 100), (4, 2, 1)  # ms
FIFTY = 50  # revolutions
TURN = 2.0 * np.pi


def drilled(program, out, **settings):
    """The result folder of the case with these settings of motion and time."""
    words = [word for key, value in settings.items() for word in ("--set", f"{key.replace('__', '.')}={value}")]
    subprocess.run([program, "run", ROOT / "cases/bit-r-rolling.toml", "-o", out, "--quiet", *words], check=True)
    return out


def speeds(folder):
    """Of cone 1 over the bit's, in each step of the second revolution."""
    with xarray.open_dataset(folder / "history.nc", decode_times=False) as history:
        turned, cone = history["rotation_angle"].values, history["cone_angle"].values[:, 0]
    return np.abs(np.diff(cone) / np.diff(turned))[turned[1:] > TURN]


def rows_of_memories(program, folder):
    for memory in MEMORIES:
        for step in STEPS:
            out = drilled(program, folder / f"{memory}-{step}", motion__cone_memory=f"'{memory} ms'", time__step=f"'{step} ms'", time__revolutions=2)
            found = speeds(out)
            yield [memory, step, f"{found.mean():.4f}", f"{found.std():.4f}", f"{np.abs(np.diff(found)).max():.4f}"]


def rows_of_fifty(program, folder):
    summary = json.loads((drilled(program, folder / "fifty", time__revolutions=FIFTY) / "summary.json").read_text(encoding="utf-8"))
    for cone in summary["cones"]:
        yield [cone["name"], *(f"{cone[key]:.4f}" for key in ("rolling_ratio_gage_row", "mean_speed_ratio", "net_slip_gage_row"))]


def write(name, headings, rows):
    with (HERE / name).open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([headings, *rows])


def main(program=ROOT / "build/release/tdbd"):
    with tempfile.TemporaryDirectory() as folder:
        write("speeds.csv", ["memory, ms", "step, ms", "mean speed", "standard deviation", "largest change in a step"],
              rows_of_memories(program, Path(folder)))
        write("fifty.csv", ["cone", "pure rolling of the gage row", "mean speed", "slip of the gage row"], rows_of_fifty(program, Path(folder)))


if __name__ == "__main__":
    main(*sys.argv[1:])
