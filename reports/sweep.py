#!/usr/bin/python3
"""Draws the table of a sweep.

    reports/sweep.py NAME.nc [-o DIR]

NAME_curves.svg   one factor: each figure over the factor, as a line with points
NAME_map.svg      two factors with levels: a heat map with contours of each figure; three: a row of maps for each figure
NAME_effects.svg  two factors or more: each figure over each factor with all points and the means of levels (main effects).
                  For a full grid each panel has the share of the variance that the means explain. For samples it has the
                  standardised regression coefficient, and the coefficient of determination R2 is beside the figure.
NAME_effects.csv  the same as numbers
NAME_parallel.svg two factors or more: one line for each point through all factors and figures, coloured by the first figure.
                  Points of the non-dominated front have thick lines.
"""

import argparse
import csv
import sys
import textwrap
from pathlib import Path

import system_python

system_python.require("matplotlib", "netCDF4", "numpy")

import matplotlib

matplotlib.use("Agg")
import matplotlib.patheffects as effects_of_paths
import matplotlib.pyplot as plt
import numpy as np
from sweep_table import in_drawn_table, main_effect, read_table, regression

plt.rcParams.update({"font.size": 8, "svg.hashsalt": "tdbd"})
DOT, MEAN, FRONT = "#9bb0c1", "#b3382c", "#1b1b1b"
MOST_MAPS = 6  # of one figure, side by side


def name_words(factor, axis):
    if factor.words:
        axis.set_xticks(range(len(factor.words)), factor.words, rotation=30, ha="right")


def set_title(fig, text):
    """The title, wrapped to the width of the figure."""
    fig.suptitle(textwrap.fill(text, max(24, int(13.0 * fig.get_figwidth()))))


def draw_effect(axis, factor, figure, note):
    axis.plot(factor.values, figure.values, ".", color=DOT, ms=3)
    places, means, _ = main_effect(factor, figure)
    axis.plot(places, means, "o-", color=MEAN, ms=4, lw=1.2)
    axis.annotate(note, (0.97, 0.95), xycoords="axes fraction", ha="right", va="top", color=MEAN)
    name_words(factor, axis)
    axis.grid(alpha=0.3)


def effects(table):
    """Rows of figures, columns of factors."""
    rows, columns = len(table.figures), len(table.factors)
    fig, axes = plt.subplots(rows, columns, figsize=(1.0 + 2.4 * columns, 0.9 + 1.7 * rows), squeeze=False, sharey="row",
                             sharex="col", layout="constrained")
    for i, figure in enumerate(table.figures):
        coefficients, explained = regression(table.factors, figure)
        for k, factor in enumerate(table.factors):
            note = f"{100.0 * main_effect(factor, figure)[2]:.0f} %" if table.is_grid else f"{coefficients[k]:.2f}"
            draw_effect(axes[i][k], factor, figure, note)
            if i == rows - 1:
                axes[i][k].set_xlabel(factor.label)
        axes[i][0].set_ylabel(textwrap.fill(figure.label, 26) + ("" if table.is_grid else f"\nR$^2$ = {explained:.2f}"))
    set_title(fig, f"{table.title}: " + ("means of levels, and their share of the variance" if table.is_grid else
                                        "means, and standardised regression coefficients"))
    return fig


def write_effects(table, path):
    """A row for each figure and factor: the share of the variance, or the coefficient and R2, and the means."""
    with path.open("w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["figure", "factor", *(["share"] if table.is_grid else ["standardised coefficient", "R2"]), "means at places"])
        for figure in table.figures:
            coefficients, explained = regression(table.factors, figure)
            for factor, coefficient in zip(table.factors, coefficients):
                places, means, share = main_effect(factor, figure)
                names = [factor.words[round(p)] if factor.words else f"{p:.4g}" for p in places]
                numbers = [f"{share:.3f}"] if table.is_grid else [f"{coefficient:.3f}", f"{explained:.3f}"]
                out.writerow([figure.described(), factor.described(), *numbers, "; ".join(f"{m:.4g} at {n}" for m, n in zip(means, names))])


def columns_of(table):
    """Panels side by side, with one panel for each figure."""
    return min(3, int(np.ceil(np.sqrt(len(table.figures)))))


def curves(table):
    """Each figure over the only factor."""
    [factor] = table.factors
    columns = columns_of(table)
    rows = -(-len(table.figures) // columns)
    fig, axes = plt.subplots(rows, columns, figsize=(1.0 + 3.4 * columns, 0.8 + 2.4 * rows), squeeze=False, sharex=True, layout="constrained")
    order = np.argsort(factor.values, kind="stable")
    for axis, figure in zip(axes.flat, table.figures):
        axis.plot(factor.values[order], figure.values[order], "o" if factor.words else "o-", color=MEAN, ms=4, lw=1.2)
        axis.set(xlabel=factor.label, ylabel=textwrap.fill(figure.label, 30))
        axis.xaxis.set_tick_params(labelbottom=True)
        name_words(factor, axis)
        axis.grid(alpha=0.3)
    for axis in axes.flat[len(table.figures):]:
        axis.set_visible(False)
    set_title(fig, table.title)
    return fig


def cells(x, y, figure, which):
    """(values of x, values of y, figure[y, x]) of the selected points; NaN: no such point."""
    xs, ys = np.unique(x.values), np.unique(y.values)
    grid = np.full((ys.size, xs.size), np.nan)
    grid[np.searchsorted(ys, y.values[which]), np.searchsorted(xs, x.values[which])] = figure.values[which]
    return xs, ys, grid


def draw_map(axis, x, y, figure, which, limits):
    """A heat map with dots at the points and, between three numbers or more of each factor, contours."""
    xs, ys, grid = cells(x, y, figure, which)
    shown = axis.pcolormesh(xs, ys, np.ma.masked_invalid(grid), shading="nearest", cmap="viridis", vmin=limits[0], vmax=limits[1])
    if not x.words and not y.words and min(grid.shape) > 2 and np.isfinite(grid).sum() > 3 and np.nanmax(grid) > np.nanmin(grid):
        lines = axis.contour(xs, ys, np.ma.masked_invalid(grid), levels=6, colors="white", linewidths=0.9)
        outline = [effects_of_paths.withStroke(linewidth=2.0, foreground="black")]
        for line in (*lines.collections, *axis.clabel(lines, fontsize=7)):
            line.set_path_effects(outline)
    axis.plot(x.values[which], y.values[which], ".", color="white", ms=3, alpha=0.7)
    axis.set_facecolor("#d9d9d9")  # failed points
    name_words(x, axis)
    if y.words:
        axis.set_yticks(range(len(y.words)), y.words)
    return shown


def maps(table):
    """A map of each figure over two factors; for three, a row of maps for each figure, over the values of the factor with the fewest."""
    rest = min(table.factors, key=lambda f: np.unique(f.values).size) if len(table.factors) == 3 else None
    y, x = (f for f in table.factors if f is not rest)
    levels = [None] if rest is None else np.unique(rest.values)
    columns = len(levels) if rest is not None else columns_of(table)
    panels = [(figure, level) for figure in table.figures for level in levels]
    rows = -(-len(panels) // columns)
    fig, axes = plt.subplots(rows, columns, figsize=(0.8 + 3.6 * columns, 0.8 + 2.9 * rows), squeeze=False, layout="constrained")
    for axis, (figure, level) in zip(axes.flat, panels):
        which = np.isfinite(figure.values) & (True if level is None else rest.values == level)
        limits = (np.nanmin(figure.values), np.nanmax(figure.values)) if np.isfinite(figure.values).any() else (0.0, 1.0)
        shown = draw_map(axis, x, y, figure, which, limits)
        axis.set(xlabel=x.label, ylabel=y.label)
        if level is not None:
            axis.set_title(f"{rest.label}: {rest.words[int(level)] if rest.words else f'{level:.4g}'}", fontsize=8)
        fig.colorbar(shown, ax=axis, label=textwrap.fill(figure.label, 30))
    for axis in axes.flat[len(panels):]:
        axis.set_visible(False)
    set_title(fig, table.title)
    return fig


def no_map(table):
    """Why a table of two or more factors has no map, or None."""
    if not table.is_grid:
        return "no map: the points are samples, and a map needs every combination of the values of two or three factors"
    if len(table.factors) > 3:
        return f"no map: the sweep has {len(table.factors)} factors, and a map shows two or three; fix the others in [set] of the design"
    if len(table.factors) == 3 and (fewest := min(np.unique(f.values).size for f in table.factors)) > MOST_MAPS:
        return f"no map: each of the three factors has {fewest} values or more, and at most {MOST_MAPS} maps are drawn side by side"
    return None


def pictures(table):
    """{kind: function that draws it}."""
    if len(table.factors) == 1:
        return {"curves": curves}
    return {**({} if no_map(table) else {"map": maps}), "effects": effects, "parallel": parallel}


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
    text = f"{table.title}: {table.front.size} points, coloured by {table.figures[0].label}{note}"
    axis.set_title(textwrap.fill(text, max(24, int(15.0 * fig.get_figwidth()))))
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
    if not table.factors or not table.figures or table.front.size == 0:
        sys.exit(f"{arguments.table}: found no point that is done, expected at least one")
    folder = arguments.output or arguments.table.parent
    folder.mkdir(parents=True, exist_ok=True)
    drawn = in_drawn_table(table)
    for kind, draw in pictures(drawn).items():
        path = folder / f"{arguments.table.stem}_{kind}.svg"
        figure = draw(drawn)
        figure.savefig(path, metadata={"Date": None, "Creator": None})
        plt.close(figure)
        print(path)
    if len(table.factors) > 1:
        effects_csv = folder / f"{arguments.table.stem}_effects.csv"
        write_effects(table, effects_csv)
        print(effects_csv)
        if reason := no_map(table):
            print(reason)
    if table.failed:
        print(f"{table.failed} points are not drawn: they failed, are missing or were rejected by the filter")


if __name__ == "__main__":
    main()
