"""Ours: the energy of a heavy body with spinning cones over more than a million steps."""

import numpy as np

from figures import results, style

SLOTS = 200
PERCENT = 100.0


def relative_change(run):
    """Time (s), and change of the total energy in per cent of its first value's size."""
    time, total = results.history(run, "time", "total_energy")
    return time, PERCENT * (total - total[0]) / abs(total[0])


def draw_change(axes, run, drift):
    """Mean and range in intervals of time: lines through all rows would hide each other."""
    label, colour, _ = style.DRIFTS[drift]
    time, change = relative_change(run)
    slots = np.array_split(np.arange(len(time)), min(SLOTS, len(time)))
    middle = [time[s].mean() for s in slots]
    axes.fill_between(middle, [change[s].min() for s in slots], [change[s].max() for s in slots],
                      color=colour, alpha=0.2, linewidth=0)
    axes.plot(middle, [change[s].mean() for s in slots], color=colour,
              label=f"{label}: {change[slots[-1]].mean():+.2g} %")


def draw(inputs):
    figure, (all_drifts, without) = style.panels(2, 1, (7.4, 6.4), sharex=True)
    for settings, run in inputs.sweep("energy"):
        drift = settings["integrator.drift"]
        draw_change(all_drifts, run, drift)
        if drift != "lie-midpoint":
            draw_change(without, run, drift)
    all_drifts.set(ylabel="change of the energy (%)", title="all drifts, with their final change")
    without.set(ylabel="change of the energy (%)", xlabel="time (s)",
                title="without the Lie midpoint, enlarged: mean and range")
    all_drifts.margins(x=0.0)
    without.margins(x=0.0, y=0.2)
    all_drifts.legend(loc="upper left")
    without.legend(loc="upper center", ncol=3)
    return figure
