#!/usr/bin/python3
"""Draws the table of a sweep.

    reports/sweep.py NAME.nc [-o DIR]

NAME_effects.svg: each figure over each factor, all points, the means of its levels (main effects) and the share of
the variance that they explain. NAME_parallel.svg: one line for each point through all factors and figures, coloured by
the first figure; points of the non-dominated front stand out. NAME_effects.csv: the means and shares as numbers.
"""

import argparse
import csv
import sys
from dataclasses import dataclass
from pathlib import Path

import system_python

system_python.require("matplotlib", "netCDF4", "numpy")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import netCDF4
import numpy as np

plt.rcParams.update({"font.size": 8, "svg.hashsalt": "tdbd"})
DOT, MEAN, FRONT = "#9bb0c1", "#b3382c", "#1b1b1b"
BINS = 8  # of a factor with more values than this


@dataclass
class Column:
    """A factor or a figure over the points. Texts are numbered in the order of their first appearance."""

    name: str
    label: str
    values: np.ndarray
    words: list  # of a factor of texts; empty: numbers


@dataclass
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


def read_table(path):
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


def name_words(factor, axis):
    if factor.words:
        axis.set_xticks(range(len(factor.words)), factor.words, rotation=30, ha="right")


def draw_effect(axis, factor, figure):
    axis.plot(factor.values, figure.values, ".", color=DOT, ms=3)
    places, means, share = main_effect(factor, figure)
    axis.plot(places, means, "o-", color=MEAN, ms=4, lw=1.2)
    axis.annotate(f"{100.0 * share:.0f} %", (0.97, 0.95), xycoords="axes fraction", ha="right", va="top", color=MEAN)
    name_words(factor, axis)
    axis.grid(alpha=0.3)


def effects(table):
    """Rows of figures, columns of factors."""
    rows, columns = len(table.figures), len(table.factors)
    fig, axes = plt.subplots(rows, columns, figsize=(1.0 + 2.4 * columns, 0.6 + 1.7 * rows), squeeze=False, sharey="row",
                             sharex="col", layout="constrained")
    for i, figure in enumerate(table.figures):
        for k, factor in enumerate(table.factors):
            draw_effect(axes[i][k], factor, figure)
            if i == rows - 1:
                axes[i][k].set_xlabel(factor.label)
        axes[i][0].set_ylabel(figure.label)
    fig.suptitle(f"{table.title}: means of levels, and their share of the variance")
    return fig


def write_effects(table, path):
    """A row for each figure and factor: the share of the variance, and the means over the factor's places."""
    with path.open("w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["figure", "factor", "share", "means at places"])
        for figure in table.figures:
            for factor in table.factors:
                places, means, share = main_effect(factor, figure)
                names = [factor.words[round(p)] if factor.words else f"{p:.4g}" for p in places]
                out.writerow([figure.label, factor.label, f"{share:.3f}", "; ".join(f"{m:.4g} at {n}" for m, n in zip(means, names))])


def scaled(column):
    """0 to 1 over the finite values; constant: the middle."""
    low, high = np.nanmin(column.values), np.nanmax(column.values)
    if not high > low:
        return np.where(np.isfinite(column.values), 0.5, np.nan)
    return (column.values - low) / (high - low)


def name_ends(axis, k, column):
    ends = (column.words[0], column.words[-1]) if column.words else (f"{np.nanmin(column.values):.4g}", f"{np.nanmax(column.values):.4g}")
    for y, text in zip((-0.02, 1.02), ends):
        axis.annotate(text, (k, y), ha="center", va="top" if y < 0 else "bottom", fontsize=7)


def parallel(table):
    columns = table.factors + table.figures
    heights = np.array([scaled(c) for c in columns])
    shade = scaled(table.figures[0])
    fig, axis = plt.subplots(figsize=(1.5 + 1.25 * len(columns), 4.2), layout="constrained")
    for point in np.argsort(table.front, kind="stable"):
        on_front = table.front[point]
        colour = plt.get_cmap("viridis")(shade[point]) if np.isfinite(shade[point]) else "#cccccc"
        axis.plot(range(len(columns)), heights[:, point], color=colour, lw=1.8 if on_front else 0.7,
                  alpha=1.0 if on_front or not table.front.any() else 0.3)
    for k, column in enumerate(columns):
        axis.axvline(k, color=FRONT, lw=0.8 if k < len(table.factors) else 1.4)
        name_ends(axis, k, column)
    axis.set_xticks(range(len(columns)), [c.label for c in columns], rotation=25, ha="right")
    axis.set_yticks([])
    axis.set_ylim(-0.12, 1.12)
    axis.spines[:].set_visible(False)
    note = f"; thick: the {int(table.front.sum())} that no other point dominates" if table.front.any() else ""
    axis.set_title(f"{table.title}: {table.front.size} points, coloured by {table.figures[0].name}{note}")
    return fig


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", type=Path)
    parser.add_argument("-o", "--output", type=Path, help="folder; default: that of the table")
    arguments = parser.parse_args()
    try:
        table = read_table(arguments.table)
    except (OSError, KeyError, IndexError, AttributeError) as error:
        sys.exit(f"{arguments.table}: found no table of a sweep ({error}), expected NAME.nc of tdbd sweep")
    if not table.figures or table.front.size == 0:
        sys.exit(f"{arguments.table}: found no point that is done, expected at least one")
    folder = arguments.output or arguments.table.parent
    folder.mkdir(parents=True, exist_ok=True)
    for kind, draw in (("effects", effects), ("parallel", parallel)):
        path = folder / f"{arguments.table.stem}_{kind}.svg"
        figure = draw(table)
        figure.savefig(path, metadata={"Date": None, "Creator": None})
        plt.close(figure)
        print(path)
    effects_csv = folder / f"{arguments.table.stem}_effects.csv"
    write_effects(table, effects_csv)
    print(effects_csv)
    if table.failed:
        print(f"{table.failed} points are not drawn: they failed, or are missing")


if __name__ == "__main__":
    main()
