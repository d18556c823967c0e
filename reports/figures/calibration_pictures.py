"""Pictures of a folder of `tdbd calibrate`: coefficients with their intervals, computed over measured loads."""

import csv
import re

import numpy as np

from figures import results, style, traces

SET_COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD)
MEASURED = re.compile(r"measured_(\w+) \[(.+)\]$")
SCALES = {"N": (1e-3, "kN"), "N m": (1e-3, "kN m")}


def sets_of(found):
    """[(words, set)] of calibration.json: one, or one for each pressure."""
    if "by_pressure" not in found:
        return [("", found)]
    return [(f"{1e-6 * s['pressure_pa']:.1f} MPa", s) for s in found["by_pressure"]]


def rows_of(found):
    """[(name, set number, coefficient)], those of one coefficient below each other."""
    sets = sets_of(found)
    names = list(dict.fromkeys(name for _, s in sets for name in s.get("coefficients", {})))
    return [(name, k, s["coefficients"][name]) for name in names for k, (_, s) in enumerate(sets) if name in s["coefficients"]]


def words_of(name, coefficient):
    """Value and interval in words."""
    unit = "" if coefficient["unit"] == "1" else f" {coefficient['unit']}"
    if coefficient["low"] is None:
        return f"{name} = {coefficient['value']:.4g}{unit}, at an end of its range: no interval"
    prior = ", mostly from the prior" if coefficient["from_prior"] else ""
    return f"{name} = {coefficient['value']:.4g}{unit}, {coefficient['low']:.4g} to {coefficient['high']:.4g}{prior}"


def draw_coefficient(axes, y, coefficient, colour):
    """The interval relative to the value: of the fit as a bar with caps, of the bootstrap below it."""
    value = coefficient["value"] or np.nan
    axes.plot(1.0, y, "o", color=colour, markersize=5, zorder=3)
    for ends, at, width in ((coefficient, y, 2.0), (coefficient.get("bootstrap") or {}, y + 0.25, 1.0)):
        if ends.get("low") is not None:
            axes.plot([ends["low"] / value, ends["high"] / value], [at, at], "|-", color=colour, linewidth=width, markersize=7,
                      alpha=1.0 if at == y else 0.6)


def coefficients(folder, title):
    """Fitted coefficients with their intervals. None for a calibration that fits nothing."""
    found = results.read_json(folder, "calibration.json")
    rows = rows_of(found)
    if not rows:
        return None
    figure, axes = style.panels(1, 1, (8.4, 1.6 + 0.5 * len(rows)))
    for y, (_, k, coefficient) in enumerate(rows):
        draw_coefficient(axes, y, coefficient, SET_COLOURS[k % len(SET_COLOURS)])
    axes.axvline(1.0, color=style.GREY, linewidth=0.8)
    axes.set_yticks(range(len(rows)), [words_of(name, c) for name, _, c in rows], fontsize=8)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    low, high = axes.get_xlim()
    axes.set_xlim(min(low, 0.9), max(high, 1.1))
    axes.grid(axis="y", visible=False)
    level = found.get("interval_level")
    axes.set_xlabel("over the fitted value" + (f"; {100 * level:.0f} % intervals" if level else "")
                    + ("; thin: of the bootstrap" if any(c.get("bootstrap") for _, _, c in rows) else ""))
    for k, (words, _) in enumerate(sets_of(found)):
        if words:
            axes.plot([], [], "o-", color=SET_COLOURS[k % len(SET_COLOURS)], label=words)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="lower right", fontsize=7)
    figure.suptitle(traces.fitted(f"Coefficients: {title}{quality(found)}", figure), fontsize=10)
    return figure


def quality(found):
    """chi2 in words, of a calibration with one set."""
    if "chi2" not in found or not found.get("degrees_of_freedom"):
        return ""
    return f"\nchi2 {found['chi2']:.3g} at {found['degrees_of_freedom']} degrees of freedom"


def read_rows(path):
    """Rows of a CSV as {column: text}; empty if there is no file."""
    if not path.is_file():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def draw_loads(axes, rows, load, look):
    """Computed over measured loads, with the interval of a reading. Returns the values that were drawn."""
    name, unit, factor = load
    label, colour, marker = look
    known = [r for r in rows if r[f"measured_{name} [{unit}]"]]
    if not known:
        return np.zeros(0)
    measured, mean, low, high = (factor * np.array([float(r[f"{c} [{unit}]"]) for r in known])
                                 for c in (f"measured_{name}", f"{name}_mean", f"{name}_low", f"{name}_high"))
    ends = np.clip([mean - low, high - mean], 0.0, None)
    axes.errorbar(measured, mean, yerr=np.where(np.isfinite(ends), ends, 0.0), fmt=marker, color=colour, markersize=4, elinewidth=0.8,
                  label=f"{label}: {len(known)} readings")
    return np.concatenate([measured, mean])


def loads_of(rows):
    """[(name, unit, factor, shown unit)] of the kinds of load in the columns."""
    found = [MEASURED.match(column) for column in (rows[0] if rows else {})]
    return [(m[1], m[2], *SCALES.get(m[2], (1.0, m[2]))) for m in found if m]


def predictions(folder, title):
    """Computed over measured loads, of fitted and of withheld records. None without readings."""
    fitted, withheld = read_rows(folder / "residuals.csv"), read_rows(folder / "predictions.csv")
    loads = loads_of(fitted or withheld)
    if not loads:
        return None
    figure, axes = style.panels(1, len(loads), (4.6 * len(loads), 4.6), squeeze=False)
    for at, (name, unit, factor, shown) in zip(axes[0], loads):
        values = np.concatenate([draw_loads(at, rows, (name, unit, factor), look) for rows, look in
                                 ((fitted, ("fitted", style.BLUE, "o")), (withheld, ("withheld", style.RED, "^")))])
        at.set(xlabel=f"measured {name} ({shown})", ylabel=f"computed {name} ({shown})")
        if values.size:
            ends = np.array([min(0.0, values.min()), 1.05 * values.max()])
            at.plot(ends, ends, color=style.GREY, linewidth=0.8, zorder=1, label="equal")
            at.legend(loc="upper left", fontsize=7)
    figure.suptitle(traces.fitted(f"Computed and measured loads, with intervals of a reading: {title}", figure), fontsize=10)
    return figure
