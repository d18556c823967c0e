"""Rotary speed and torque along a drill string over a cycle of stick-slip, from string.nc, with the paths of waves."""

import numpy as np

from figures import results, style
from figures.string_pictures import depth_of

RPM = 30.0 / np.pi
LEAD = 1.0  # s shown before the bit comes to rest
STILL = 0.02  # of the mean speed: the bit is at rest below


def stops(time, speed):
    """Times at which the bit comes to rest, and those at which it starts again."""
    still = speed < STILL * speed.mean()
    return time[1:][still[1:] & ~still[:-1]], time[1:][~still[1:] & still[:-1]]


def cycle(time, speed):
    """(stop, start, next stop) of the last whole cycle."""
    rests, starts = stops(time, speed)
    if len(rests) < 2:
        return None
    return rests[-2], starts[starts > rests[-2]][0], rests[-1]


def torsional_wave_speed(summary):
    """m/s, of a result of tdbd string."""
    return summary["courant"]["torsional"] * summary["element_length_m"] / summary["step_s"]


def draw_map(axes, time, depth, values, words, colours):
    shown = axes.pcolormesh(time, depth, values.T, shading="nearest", cmap=colours, rasterized=True)
    axes.figure.colorbar(shown, ax=axes, label=words)
    axes.set(ylabel="measured depth (m)", ylim=(depth[-1], depth[0]))
    axes.grid(False)


def draw_waves(axes, start, depth, wave_speed):
    """A wave that leaves the bit, is reflected at the top and comes back."""
    travel = depth / wave_speed
    axes.plot([start, start + travel, start + 2.0 * travel], [depth, 0.0, depth], color="white", linestyle="--", linewidth=1.0)


def draw(inputs):
    import xarray

    folder = inputs.folder("string-vertical")
    with xarray.open_dataset(folder / "string.nc", decode_times=False) as data:
        time, speed, torque = (data[name].values for name in ("time", "rotary_speed", "torque"))
        nodes, elements = depth_of(data["node_depth"].values), depth_of(data["element_depth"].values)
    found = cycle(time, speed[:, -1])
    if found is None:
        return style.only_words("a cycle of stick-slip")
    stop, start, following = found
    shown = (time >= stop - LEAD) & (time <= following + LEAD)
    wave_speed = torsional_wave_speed(results.summary(folder))
    figure, (upper, lower) = style.panels(2, 1, (7.5, 6.4), sharex=True)
    draw_map(upper, time[shown], nodes, RPM * speed[shown], "rotary speed (rpm)", "viridis")
    draw_map(lower, time[shown], elements, 1e-3 * torque[shown], "torque (kN m)", "magma")
    for axes in (upper, lower):
        for leaves in (stop, start):
            draw_waves(axes, leaves, nodes[-1], wave_speed)
    lower.set_xlabel("time (s)")
    return figure
