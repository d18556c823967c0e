"""Figures of the comparisons: measured over predicted loads, one figure each, and one with all errors and floors."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
sys.path.append(str(Path(__file__).resolve().parents[1] / "reports" / "figures"))
import style  # noqa: E402 (found through the line above)

LABELS = {"wob": "WOB", "tob": "TOB", "normal": "force into the rock", "drag": "drag"}
TRUTH = {"measured": "measured", "published model": "published model", "synthetic laboratory": "laboratory (synthetic)"}
UNITS = {"N": (1e3, "kN"), "N m": (1.0, "N m")}
LOOKS = ((style.BLUE, "o"), (style.RED, "^"), (style.GREEN, "s"), (style.PURPLE, "D"))


def by_name(compared):
    """Returns {comparison: those of all laws}."""
    return {name: [c for c in compared if c.name == name] for name in dict.fromkeys(c.name for c in compared)}


def limits(values):
    return 0.8 * min(values), 1.25 * max(values)


def draw_load(axes, group, k):
    """One load of a comparison: a point per record and law, the line of a perfect law, and the floor around it."""
    first = group[0].loads[k]
    scale, unit = UNITS[first.unit]
    low, high = limits([v / scale for c in group for v in c.loads[k].predicted + c.loads[k].measured])
    ends = [low, high]
    axes.fill_between(ends, [x * (1.0 - first.floor.rms) for x in ends], [x * (1.0 + first.floor.rms) for x in ends],
                      color="0.9", linewidth=0, label=f"floor, {100 * first.floor.rms:.0f} %")
    axes.plot(ends, ends, color=style.GREY, linewidth=0.8)
    for c, (colour, marker) in zip(group, LOOKS):
        load = c.loads[k]
        axes.plot([v / scale for v in load.predicted], [v / scale for v in load.measured], marker, color=colour,
                  markerfacecolor="none", label=f"{c.law}: {100 * load.mean():+.0f} %, rms {100 * load.rms():.0f} %")
    axes.set(xscale="log", yscale="log", xlim=ends, ylim=ends, aspect="equal",
             xlabel=f"{LABELS[first.name]} predicted ({unit})", ylabel=f"{TRUTH[group[0].kind]} ({unit})")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 1.5, 2, 3, 5, 7)))
        axis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
        axis.set_minor_locator(matplotlib.ticker.NullLocator())
    axes.legend(loc="upper left", fontsize=7)


def draw_one(group):
    columns = len(group[0].loads)
    figure, axes = style.panels(1, columns, (4.2 * columns + 0.4, 4.9), squeeze=False)
    for k in range(columns):
        draw_load(axes[0][k], group, k)
    first = group[0]
    figure.suptitle(f"{first.title}\n{first.kind}; floor: {first.floor_of}", fontsize=8.5 if columns > 1 else 7.5)
    return figure


def draw_errors(compared):
    """The worst load of each comparison and law: its error divided by its floor."""
    ordered = compared[::-1]
    figure, axes = style.panels(1, 1, (7.4, 0.9 + 0.21 * len(ordered)))
    worst = [max(c.in_floors(), 0.1) for c in ordered]
    colours = [style.GREEN if w <= 1 else style.GOLD if w <= 2 else style.RED for w in worst]
    axes.barh(range(len(ordered)), worst, color=colours, height=0.7)
    axes.set_yticks(range(len(ordered)), [f"{c.name}, {c.law}" for c in ordered], fontsize=7)
    axes.set(xscale="log", xlabel="mean or rms error of the worst load over its floor", ylim=(-0.6, len(ordered) - 0.4))
    for x in (1, 2):
        axes.axvline(x, color=style.BLACK, linewidth=0.8)
    axes.xaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 3, 5, 7)))
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    axes.grid(False, axis="y")
    axes.set_title("green: within the floor; gold: within 2 floors; red: fails")
    return figure


def save(figure, path):
    figure.savefig(path, dpi=style.DPI, metadata={"Software": None})


def draw_all(folder, compared):
    """Writes comparison-NAME.png for each comparison, and comparisons.png for all."""
    for name, group in by_name(compared).items():
        save(draw_one(group), folder / f"comparison-{name}.png")
    save(draw_errors(compared), folder / "comparisons.png")
