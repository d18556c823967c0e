#!/usr/bin/python3
"""The levels of cases.csv with a program of before forces and resistances were one flow, and its cases.

    before.py --program PROGRAM --cases FOLDER [--only NAME ...]
    before.py --program PROGRAM --today drill-bit-b-whirl     the case as it is now, in a row "NAME, present settings"

FOLDER is `cases` of that program's commit. Writes before.csv beside itself: for every case and quantity the value with the
shipped settings and the values over steps and over edges. "advance" is displacement over time from the history, over the
times of the means; "rop_mean" is what that program reports. Other cases' rows are kept. Half an hour on one core.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import numpy as np
import xarray

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "reports"))
from study_tools import read_rows, write_rows  # noqa: E402

NAMES = ["drill-bit-b", "drill-bit-b-whirl", "drill-bit-r", "bit-bounce", "laboratory", "stick-slip", "high-frequency",
         "high-frequency-beds"]
QUANTITIES = {"wob_mean": ("wob_mean_n", "N"), "tob_mean": ("tob_mean_n_m", "N m"), "advance": ("advance", "m/s"),
              "rop_mean": ("rop_mean_m_per_s", "m/s"), "rotary_speed_mean": ("rotary_speed_mean_rad_per_s", "rad/s")}
KEYS = {"step": "time.step", "edge": "rock.edge_length"}
ROWS = 2000  # of a history


def advance(out, summary):
    """Displacement of the bit over the rock, over time, m/s: from the row nearest to the begin of the means."""
    with xarray.open_dataset(out / "history.nc") as history:
        time, z = history.time.values, history.position_z.values
        if "rock_position_z" in history:
            z = z - history.rock_position_z.values
    first = int(np.argmin(np.abs(time - summary["means_from_s"])))
    return float((z[-1] - z[first]) / (time[-1] - time[first]))


def figures(program, case, key, size, steps):
    """{quantity: value} of one run of this many steps."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        command = [program, "run", case, "-o", out, "--quiet", "--set", f"{key}={size!r}", "--set", "output.energy_order=off",
                   "--set", f"output.history_every={max(1, round(steps / ROWS))}"]
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
        summary["advance"] = advance(out, summary)
    return {quantity: summary[name] for quantity, (name, _) in QUANTITIES.items()}


def seconds(quantity):
    number, unit = quantity.split()
    return float(number) * {"ms": 1e-3, "s": 1.0}[unit]


def rows_of(program, case, name, label):
    time = tomllib.loads(case.read_text(encoding="utf-8"))["time"]
    now = next(r for r in read_rows(HERE / "cases.csv") if r["case"] == name)
    columns, shipped = {}, {}
    for which, key in KEYS.items():
        sizes = [float(s) for s in now[f"{which}s"].split()]
        steps = [seconds(time["duration"]) / (s if which == "step" else seconds(time["step"])) for s in sizes]
        found = [figures(program, case, key, s, n) for s, n in zip(sizes, steps, strict=True)]
        columns[which] = now[f"{which}s"], found
        if which == "step":
            shipped = found[int(np.argmin(np.abs(np.array(sizes) - seconds(time["step"]))))]
    for quantity, (_, unit) in QUANTITIES.items():
        row = {"case": label, "quantity": quantity, "unit": unit, "value": f"{shipped[quantity]:.6g}"}
        for which, (sizes, found) in columns.items():
            row[f"{which}s"] = sizes
            row[f"by_{which}"] = " ".join(f"{f[quantity]:.6g}" for f in found)
        yield row


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--cases", type=pathlib.Path, default=ROOT / "cases", help="folder of that program's cases")
    parser.add_argument("--only", nargs="+", default=NAMES, choices=NAMES)
    parser.add_argument("--today", nargs="+", default=[], choices=NAMES, help="cases as they are now, instead")
    arguments = parser.parse_args()
    table = HERE / "before.csv"
    folder, names = (ROOT / "cases", arguments.today) if arguments.today else (arguments.cases, arguments.only)
    for name in names:
        label = f"{name}, present settings" if arguments.today else name
        kept = read_rows(table) if table.exists() else []
        kept = [r for r in kept if r["case"] != label]
        rows = kept + list(rows_of(arguments.program, folder / f"{name}.toml", name, label))
        rows.sort(key=lambda r: (NAMES.index(r["case"].partition(",")[0]), r["case"]))
        write_rows(table, rows)
        print(label, flush=True)


if __name__ == "__main__":
    main()
