#!/usr/bin/python3
"""Convergence of every shipped dynamic case: `tdbd converge` over five time steps and four edge lengths.

    measure.py [--cases NAME ...] [--tdbd PROGRAM] [--jobs N]

Writes cases.csv beside itself: for every case and quantity the value with the shipped settings, the
values over steps and over edges, observed orders, and the uncertainty of the shipped value by step, by
mesh and by sampling. Other cases' rows are kept. Writes cases/convergence/CASE.json, too: what the case's
own runs read, `output.convergence`, to state the uncertainty of their means. Forty minutes on one core;
requires a release build.
"""

import argparse
import concurrent.futures
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "reports"))
from study_tools import write_rows  # noqa: E402

CASES = ["drill-bit-b", "drill-bit-b-whirl", "drill-bit-b-whirl-rock", "drill-bit-r", "stick-slip", "bit-bounce",
         "high-frequency", "high-frequency-beds", "laboratory"]
QUANTITIES = ["wob_mean", "tob_mean", "rop_mean", "rotary_speed_mean", "cone_speed_ratios", "torsional_frequency",
              "axial_frequency", "stick_slip_severity", "wob_swing", "orbit_radius", "orbit_frequency"]
# What a run reads of a study: src/simulation/case/studied_convergence.hpp.
READ = ["wob_mean", "tob_mean", "rop_mean", "rotary_speed_mean", "stick_slip_severity", "torsional_frequency", "orbit_radius",
        "orbit_frequency"]
SAMPLING = {"wob_mean": "wob_mean_n", "tob_mean": "tob_mean_n_m", "rop_mean": "rop_mean_m_per_s",
            "rotary_speed_mean": "rotary_speed_mean_rad_per_s"}
STUDIES = {"step": ("time.step", 5, 2.0), "edge": ("rock.edge_length", 4, 2.0**0.5)}  # key, levels, factor
ABOVE = 2.0  # the coarsest level over the shipped value, where such a step is stable
UNITS = {"ms": 1e-3, "s": 1.0, "mm": 1e-3, "m": 1.0}


def si(quantity):
    """A length or a time of a case file."""
    if not isinstance(quantity, str):
        return float(quantity)
    number, unit = re.fullmatch(r"([0-9.e+-]+) *([a-z]+)", quantity).groups()
    return float(number) * UNITS[unit]


def shipped(name, key):
    table, entry = key.split(".")
    return si(tomllib.loads((ROOT / f"cases/{name}.toml").read_text(encoding="utf-8"))[table][entry])


def is_valid(tdbd, name, key, value):
    command = [tdbd, "check", ROOT / f"cases/{name}.toml", "--set", f"{key}={value!r}"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def study(tdbd, name, which, folder):
    """Levels of one study from its coarsest on, and the index of the shipped one."""
    key, levels, factor = STUDIES[which]
    own = shipped(name, key)
    start = ABOVE * own if is_valid(tdbd, name, key, ABOVE * own) else own
    out = pathlib.Path(folder) / f"{name}-{which}"
    command = [tdbd, "converge", ROOT / f"cases/{name}.toml", "--over", key, "--levels", str(levels), "--factor", repr(factor),
               "--set", f"{key}={start!r}", "--set", "output.energy_order=off", "--set", 'output.convergence=""', "-o", out, "--quiet"]
    subprocess.run(command, check=True)
    result = json.loads((out / "convergence.json").read_text(encoding="utf-8"))
    sizes = [level["size"] for level in result["levels"]]
    return result, min(range(len(sizes)), key=lambda i: abs(sizes[i] - own))


def values(result, quantity):
    """One number a level: a mean over cones."""
    found = [level["state"].get(quantity) for level in result["levels"]]
    return [sum(v) / len(v) for v in found] if all(found) else None


def write_for_runs(name, results):
    """The studies of a case, without what its runs do not read."""
    short = [{"keys": result["keys"],
              "levels": [{"sizes": level["sizes"], "state": {q: level["state"][q] for q in READ if q in level["state"]}}
                         for level in result["levels"]],
              "variables": {q: {"uncertainty": {"value": result["variables"][q]["uncertainty"]["value"]}}
                            for q in READ if q in result["variables"]}}
             for result in results]
    file = ROOT / f"cases/convergence/{name}.json"
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps(short, indent=1) + "\n", encoding="utf-8")


def mean_of_sampling(tdbd, name, folder):
    out = pathlib.Path(folder) / name
    subprocess.run([tdbd, "run", ROOT / f"cases/{name}.toml", "-o", out, "--quiet", "--set", "output.energy_order=off",
                    "--set", 'output.convergence=""'], check=True)
    return json.loads((out / "summary.json").read_text(encoding="utf-8"))["uncertainty"]


def rows_of(tdbd, name):
    with tempfile.TemporaryDirectory() as folder:
        studies = {which: study(tdbd, name, which, folder) for which in STUDIES}
        sampling = mean_of_sampling(tdbd, name, folder)
    write_for_runs(name, [result for result, at in studies.values()])
    for quantity in QUANTITIES:
        if values(studies["step"][0], quantity) is None:
            continue
        row = {"case": name, "quantity": quantity}
        for which, (result, at) in studies.items():
            of_levels = values(result, quantity)
            variable = result["variables"][quantity]
            left = variable["uncertainty"]["value"]
            row["unit"] = variable["units"]
            row["value"] = of_levels[at]
            row[f"{which}s"] = " ".join(f"{level['size']:.6g}" for level in result["levels"])
            row[f"by_{which}"] = " ".join(f"{v:.6g}" for v in of_levels)
            row[f"order_{which}"] = variable["order"] if variable["order"] is not None else ""
            row[f"slope_{which}"] = variable["order_of_all"]
            # The change to the finest level, and what is left there.
            row[f"uncertainty_{which}"] = abs(of_levels[at] - of_levels[-1]) + left
        row["uncertainty_sampling"] = sampling[SAMPLING[quantity]] if quantity in SAMPLING else ""
        yield row


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", nargs="+", default=CASES, choices=CASES)
    parser.add_argument("--tdbd", default=str(ROOT / "build/release/tdbd"))
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    table = HERE / "cases.csv"
    kept = []
    if table.exists():
        with table.open(encoding="utf-8") as file:
            kept = [row for row in csv.DictReader(file) if row["case"] not in arguments.cases]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for rows in pool.map(lambda name: list(rows_of(arguments.tdbd, name)), arguments.cases):
            kept += rows
            kept.sort(key=lambda row: CASES.index(row["case"]))
            write_rows(table, kept)


if __name__ == "__main__":
    main()
