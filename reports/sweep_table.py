"""A sweep's table as columns, and what one factor alone explains of a figure."""

import dataclasses

import netCDF4
import numpy as np

BINS = 8  # of a factor with more values than this


@dataclasses.dataclass
class Column:
    """A factor or a figure over the points. Texts are numbered in the order of their first appearance."""

    name: str
    label: str
    values: np.ndarray
    words: list  # of a factor of texts; empty: numbers


@dataclasses.dataclass
class Table:
    title: str
    factors: list
    figures: list
    front: np.ndarray  # True: not dominated; all False without goals
    failed: int


def column_of(variable):
    unit = getattr(variable, "units", "1")
    name = variable.name
    if variable.dtype is str:
        words = list(dict.fromkeys(variable[:]))
        return Column(name, name, np.array([float(words.index(w)) for w in variable[:]]), words)
    return Column(name, name if unit == "1" else f"{name} [{unit}]", np.ma.filled(variable[:], np.nan).astype(float), [])


def read(path):
    """The points of NAME.nc that are done. Raises OSError where it is no NetCDF file, KeyError where it is no sweep's."""
    with netCDF4.Dataset(path) as data:
        done = np.ma.filled(data["status"][:], 1) == 0
        front = np.ma.filled(data["front"][:], 0) == 1 if "front" in data.variables else np.zeros(done.size, bool)
        columns = {kind: [column_of(v) for v in data.variables.values() if getattr(v, "long_name", "").startswith(kind)]
                   for kind in ("factor ", "figure ")}
        for column in columns["factor "] + columns["figure "]:
            column.values = column.values[done]
        return Table(data.title, columns["factor "], columns["figure "], front[done], int((~done).sum()))


def groups_of(factor):
    """[(middle, which points)]: one for each value, or equal shares of the points of a factor that was sampled."""
    values = np.unique(factor.values)
    if values.size <= BINS:
        return [(v, factor.values == v) for v in values]
    order = np.argsort(factor.values, kind="stable")
    return [(factor.values[part].mean(), np.isin(np.arange(order.size), part)) for part in np.array_split(order, BINS)]


def main_effect(factor, figure):
    """([place], [mean], share): the means of a figure over groups of a factor, and their variance over the whole
    variance (eta squared, the first-order sensitivity of a full design). Points whose figure is no number are left out."""
    known = np.isfinite(figure.values)
    groups = [(place, figure.values[which & known]) for place, which in groups_of(factor)]
    groups = [(place, values) for place, values in groups if values.size]
    if not groups:
        return [], [], np.nan
    whole = figure.values[known]
    between = sum(values.size * (values.mean() - whole.mean()) ** 2 for _, values in groups) / whole.size
    share = between / whole.var() if whole.var() > 0.0 else 0.0
    return [place for place, _ in groups], [values.mean() for _, values in groups], share
