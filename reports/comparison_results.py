"""Reads one result folder of tdbd-compare: comparison.csv, parts.csv, comparison.json, comparison.nc."""

import csv
import json
from functools import cached_property
from pathlib import Path

import netCDF4
import numpy as np


def rows_of(path):
    with Path(path).open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Result:
    """What the models said about one case."""

    def __init__(self, folder, costs=None):
        """costs: {model: CPU seconds a simulated second} (comparison_costs.py)."""
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
        """{(model, quantity): number}, of those that models say."""
        return {(r["model"], r["quantity"]): float(r["value"]) for r in rows_of(self.folder / "comparison.csv") if r["value"]}

    @cached_property
    def reasons(self):
        """{(model, quantity): why the model cannot say it}."""
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
        with netCDF4.Dataset(self.folder / "comparison.nc") as file:
            if "bottom_depth" not in file.variables or model not in self.titles:
                return None
            at = list(file["model"][:]).index(model)
            samples = int(file["circle_samples"][at])
            return np.array(file["bottom_depth"][at, :samples]) if samples else None

    def harmonics(self, model):
        """Amplitudes (m) of the bottom's waves round the circle, by their number; None without a bottom."""
        depth = self.circle(model)
        if depth is None:
            return None
        waves = 2.0 * np.abs(np.fft.rfft(depth - depth.mean())) / len(depth)
        return waves

    def strongest(self, model, count=4):
        """Numbers of the strongest waves, or None."""
        waves = self.harmonics(model)
        return None if waves is None else [int(k) for k in np.argsort(-waves)[:count]]


def said(runs, quantity):
    """[(result, model, number)] of all runs and models that say it."""
    return [(r, m, r.value(m, quantity)) for _, r in runs for m in r.titles if r.value(m, quantity) is not None]
