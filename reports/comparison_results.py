"""Reads one result folder of tdbd-compare (comparison.csv, parts.csv, comparison.json, comparison.nc) and the processor times of all runs.

    comparison_results.py RESULTS    writes comparison_costs.csv from the timing.json of the runs below RESULTS
                                     (results/report/comparison/data)

Processor time is measured once and committed, so that the page is bitwise reproducible. Measure it again when a run or a model changes,
on a quiet machine.
"""

import csv
import json
import sys
from functools import cached_property
from pathlib import Path

from fingerprint import Stale

HERE = Path(__file__).parent
COSTS = "comparison_costs.csv"
HEADS = ("run", "model", "cpu_s", "simulated_s")


def measured_costs(results):
    """Rows of all runs below a folder."""
    rows = []
    for file in sorted(Path(results).rglob("timing.json")):
        models = json.loads(file.read_text(encoding="utf-8"))["models"]
        rows += [(file.parent.relative_to(results).as_posix(), model, t["cpu_s"], t["simulated_s"]) for model, t in models.items()]
    return rows


def write_costs(path, rows):
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEADS)
        table.writerows(rows)


def read_costs(path):
    """{run: {model: CPU seconds a simulated second, None of a model without time}}; nothing of a file that is not there. Raises Stale of a line
    that is none of these."""
    costs = {}
    if not Path(path).is_file():
        return costs
    with Path(path).open(newline="", encoding="utf-8") as file:
        for number, row in enumerate(csv.reader(file), 1):
            if number == 1 and tuple(row) == HEADS:
                continue
            try:
                run, model, cpu, simulated = row[0], row[1], *map(float, row[2:])
            except (ValueError, IndexError):
                raise Stale(f"{path}:{number}: found {','.join(row)!r}, expected {','.join(HEADS)}") from None
            costs.setdefault(run, {})[model] = cpu / simulated if simulated else None
    return costs


def costs_of(costs, run, path):
    """Those of a run. Raises Stale when it was never measured."""
    if run not in costs:
        raise Stale(f"{path}: found no processor time of the run {run}, expected that of each model: python3 reports/{Path(__file__).name} "
                    "results/report/comparison/data writes it")
    return costs[run]


def rows_of(path):
    with Path(path).open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Result:
    """The results of all models for one case."""

    def __init__(self, folder, costs=None):
        """costs: {model: CPU seconds a simulated second} (costs_of)."""
        self.folder, self.costs = Path(folder), costs or {}

    def document(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    @cached_property
    def info(self):
        return self.document("comparison.json")

    @cached_property
    def titles(self):
        """{model: title}, in their order."""
        return {m["name"]: m["title"] for m in self.info["models"]}

    @cached_property
    def says(self):
        """{(model, quantity): number}, of those that models compute."""
        return {(r["model"], r["quantity"]): float(r["value"]) for r in rows_of(self.folder / "comparison.csv") if r["value"]}

    @cached_property
    def reasons(self):
        """{(model, quantity): why the model has no value}."""
        return {(r["model"], r["quantity"]): r["reason"] for r in rows_of(self.folder / "comparison.csv") if not r["value"]}

    @property
    def quantities(self):
        """{quantity: unit}, in their order."""
        return self.info["units"]

    def value(self, model, quantity):
        """The model's number, or None."""
        return self.says.get((model, quantity))

    @cached_property
    def part_rows(self):
        return [r | {"value": float(r["value"]), "radius_m": float(r["radius_m"])} for r in rows_of(self.folder / "parts.csv")]

    def parts(self, model, quantity):
        """{part: (radius, value)} of a model."""
        return {r["part"]: (r["radius_m"], r["value"]) for r in self.part_rows if r["model"] == model and r["quantity"] == quantity}

    def cost(self, model):
        """CPU seconds a simulated second; None of a model without time."""
        return self.costs.get(model)

    @property
    def advance(self):
        """m a revolution."""
        return self.info["advance_m_per_revolution"]

    @property
    def gage_radius(self):
        return self.info["gage_radius_m"]

    def circle(self, model):
        """Depths (m) at equal angles of the compared circle, or None."""
        import netCDF4  # here, as scripts/report reads this file each time and mostly needs no bottom: it takes half of the start

        with netCDF4.Dataset(self.folder / "comparison.nc") as file:
            if "bottom_depth" not in file.variables or model not in self.titles:
                return None
            at = list(file["model"][:]).index(model)
            samples = int(file["circle_samples"][at])
            return file["bottom_depth"][at, :samples].filled() if samples else None

    def harmonics(self, model):
        """Amplitudes (m) of the bottom's waves round the circle, by their number; None without a bottom."""
        depth = self.circle(model)
        if depth is None:
            return None
        import numpy as np

        waves = 2.0 * np.abs(np.fft.rfft(depth - depth.mean())) / len(depth)
        return waves

    def strongest(self, model, count=4):
        """Numbers of the strongest waves, or None."""
        waves = self.harmonics(model)
        return None if waves is None else [int(k) for k in (-waves).argsort()[:count]]


def said(runs, quantity):
    """[(result, model, number)] of all runs and models that have a value."""
    return [(r, m, r.value(m, quantity)) for _, r in runs for m in r.titles if r.value(m, quantity) is not None]


if __name__ == "__main__":
    write_costs(HERE / COSTS, measured_costs(sys.argv[1]))
