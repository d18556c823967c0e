#!/usr/bin/python3
"""Draws the table of tdbd curve.

    reports/curve.py FOLDER [-o DIR]

curve.png   the rate of penetration over the weight on bit, and the torque over the weight, with a line for each rock. Bars are the
            intervals of the means (95 %). Stars are the weights that were found for the rate, from rates.csv.
"""

import argparse
import csv
import sys
from pathlib import Path

import system_python

system_python.require("matplotlib", "numpy")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

COLUMNS = ("rock", "weight_set_n", "wob_mean_n", "wob_interval_n", "rop_mean_m_per_h", "rop_interval_m_per_h", "tob_mean_n_m",
           "tob_interval_n_m")
KILO = 1e-3


def read_rows(path):
    """The rows of a CSV file. Raises ValueError if it has none or lacks a column."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    missing = [name for name in COLUMNS if not rows or name not in rows[0]]
    if missing:
        raise ValueError(f"{path}: found no column {missing[0]} with values, expected curve.csv of tdbd curve")
    return rows


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


def found_weights(folder):
    """{rock: (weight in kN, rate in m/h)} of rates.csv, if there is one."""
    return {row["rock"]: (KILO * float(row["weight_set_n"]), float(row["rop_mean_m_per_h"])) for row in rates(folder)
            if row["result"] in ("found", "within-interval")}


def draw_line(axis, rows, name, colour):
    """One curve over the mean weight, with the intervals of both; returns it."""
    weight = KILO * column(rows, "wob_mean_n")
    unit = "m_per_h" if name == "rop" else "n_m"
    y, bars = column(rows, f"{name}_mean_{unit}"), column(rows, f"{name}_interval_{unit}")
    known = np.isfinite(weight) & np.isfinite(y)
    across = np.nan_to_num(KILO * column(rows, "wob_interval_n"))
    return axis.errorbar(weight[known], y[known], yerr=np.nan_to_num(bars)[known], xerr=across[known], fmt="o-", color=colour, ms=4, lw=1.3,
                         elinewidth=0.8, capsize=2, label=rows[0]["rock"])


def rates(folder):
    """The rows of rates.csv; none without the file."""
    path = Path(folder) / "rates.csv"
    if not path.is_file():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def figure_of(folder):
    """The figure of curve.csv of a folder. Raises OSError or ValueError if there is none."""
    folder = Path(folder)
    rows = read_rows(folder / "curve.csv")
    rocks = list(dict.fromkeys(row["rock"] for row in rows))
    found = found_weights(folder)
    with plt.rc_context({"font.size": 9}):
        fig, (rate, torque) = plt.subplots(1, 2, figsize=(9.0, 3.8), layout="constrained")
        for k, rock in enumerate(rocks):
            of_rock = [row for row in rows if row["rock"] == rock]
            colour = plt.get_cmap("tab10")(k % 10)
            draw_line(rate, of_rock, "rop", colour)
            lines = draw_line(torque, of_rock, "tob", colour)
            if rock in found:
                weight, reached = found[rock]
                rate.plot([weight], [reached], "*", color=colour, ms=13, mec="black", mew=0.7, zorder=3)
                lines.set_label(f"{rock}: {weight:.4g} kN for {reached:.3g} m/h")
        for axis, label in ((rate, "rate of penetration [m/h]"), (torque, "torque on bit [N m]")):
            axis.set(xlabel="weight on bit [kN]", ylabel=label)
            axis.set_xlim(left=0.0)
            axis.set_ylim(bottom=0.0)
            axis.grid(alpha=0.3)
        if len(rocks) > 1 or found:
            torque.legend(fontsize=8)
    return fig


def draw_curve(folder, out):
    """Draws curve.csv of a folder and returns the path of the picture, OUT/curve.png. Raises OSError or ValueError if there is none."""
    out = Path(out)
    fig = figure_of(folder)
    path = out / "curve.png"
    out.mkdir(parents=True, exist_ok=True)
    with plt.rc_context({"font.size": 9}):
        fig.savefig(path, dpi=160, metadata={"Software": None})
    plt.close(fig)
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("-o", "--output", type=Path, help="folder; default: that of the table")
    arguments = parser.parse_args()
    try:
        print(draw_curve(arguments.folder, arguments.output or arguments.folder))
    except (OSError, ValueError) as error:
        sys.exit(f"{arguments.folder}: found no curve ({error}), expected a folder of tdbd curve")


if __name__ == "__main__":
    main()
