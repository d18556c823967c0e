"""Ours: the energy of a heavy body with spinning cones over more than a million steps."""

import numpy as np

from figures import results, style


def relative_change(run):
    """Time (s), and change of the total energy over its first value's size."""
    time, total = results.history(run, "time", "total_energy")
    return time, (total - total[0]) / abs(total[0])


def draw_change(axes, run, drift, width):
    """Mean and range in slots of time: the lines of 10 000 rows would hide each other."""
    label, colour, _ = style.DRIFTS[drift]
    time, change = relative_change(run)
    slots = np.array_split(np.arange(len(time)), min(width, len(time)))
    middle = [time[s].mean() for s in slots]
    axes.fill_between(middle, [change[s].min() for s in slots], [change[s].max() for s in slots],
                      color=colour, alpha=0.25, linewidth=0)
    axes.plot(middle, [change[s].mean() for s in slots], color=colour,
              label=f"{label}: {100 * change[slots[-1]].mean():+.2g} % at the end")


def draw(inputs):
    figure, (all_drifts, without) = style.panels(2, 1, (7.4, 6.4), sharex=True)
    for settings, run in inputs.sweep("energy"):
        drift = settings["integrator.drift"]
        draw_change(all_drifts, run, drift, 200)
        if drift != "lie-midpoint":
            draw_change(without, run, drift, 200)
    all_drifts.set(ylabel="relative change of the energy", title="all drifts")
    without.set(ylabel="relative change of the energy", xlabel="time (s)",
                title="without the Lie midpoint: bounded", xlim=(0.0, None))
    for axes in (all_drifts, without):
        axes.legend(loc="best")
    return figure
