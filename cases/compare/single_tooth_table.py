#!/usr/bin/python3
"""single_tooth_table.py TDBD OUT.csv [--check]: a table of single-tooth tests, from a run of cases/single-tooth.toml.

A row every 0.25 mm of depth: the mean force of a straight line through the readings around it, and the radius of
the disc by whose area the removed volume grows with depth there. --check compares with the file instead of writing it.
"""

import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

EVERY = 0.25e-3  # m
HEADER = "depth [mm], force [N], crater_radius [mm]"


def columns(history):
    names = history.read_text(encoding="utf-8").split("\n", 1)[0].split(",")
    values = np.loadtxt(history, delimiter=",", skiprows=1)
    return {name.split(" [")[0]: values[:, i] for i, name in enumerate(names)}


def line_at(x, y, middle):
    """Value and slope at `middle` of the least-squares line through the points within half a row of it."""
    near = np.abs(x - middle) <= EVERY / 2 + 1e-9
    slope, value = np.polyfit(x[near] - middle, y[near], 1)
    return value, slope


def table(history):
    c = columns(history)
    depth, rows = c["position_z"], [(0.0, 0.0, 0.0)]
    for i in range(1, int(round(depth[-1] / EVERY))):
        force, _ = line_at(depth, c["weight_on_bit"], i * EVERY)
        _, area = line_at(depth, c["removed_volume_total"], i * EVERY)
        rows.append((1e3 * i * EVERY, force, 1e3 * math.sqrt(area / math.pi)))
    return rows


def text_of(program):
    case = pathlib.Path(__file__).parents[1] / "single-tooth.toml"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "run"
        subprocess.run([program, "run", case, "-o", folder], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        rows = table(folder / "history.csv")
    lines = ["# synthetic: made by cases/compare/single_tooth_table.py from a run of cases/single-tooth.toml;",
             "# a ball of 6 mm radius pressed into rock of 100 MPa under the law \"indentation\" of the program itself.",
             HEADER, *(f"{d:.2f}, {f:.1f}, {r:.4f}" for d, f, r in rows)]
    return "\n".join(lines) + "\n"


def main(program, out, check=None):
    text, path = text_of(program), pathlib.Path(out)
    if check is None:
        path.write_text(text, encoding="utf-8")
    elif text != path.read_text(encoding="utf-8"):
        sys.exit(f"{out}: not what {__file__} makes of the program")


if __name__ == "__main__":
    main(*sys.argv[1:])
