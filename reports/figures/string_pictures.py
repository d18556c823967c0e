"""Pictures of a folder of `tdbd string`: torque and drag, broomstick plot, mode shapes, time-depth maps; a cycle of stick-slip along the
string, and its delay at the surface."""

import csv
import json
import math

import matplotlib.pyplot as plt
import numpy as np

from figures import results, style

# Pictures of a folder of tdbd string: torque and drag, broomstick plot, mode shapes, time-depth maps.

NAMES = {"pull_up": "pull up", "slack_off": "slack off", "rotate": "rotate off bottom", "drill": "drill"}
COLOURS = {"pull_up": "#b3382c", "slack_off": "#1b6ca8", "rotate": "#2a9d5c", "drill": "#d98e04"}


def columns_of(file):
    """Columns of a CSV by name."""
    with open(file, encoding="utf-8") as stream:
        rows = list(csv.reader(stream))
    values = np.array(rows[1:], dtype=float)
    return dict(zip(rows[0], values.T))


def downward(ax, label):
    ax.invert_yaxis()
    ax.set_ylabel(label)
    ax.grid(alpha=0.3)


def torque_and_drag(folder):
    """Tension and torque over measured depth, of every operation."""
    table = columns_of(folder / "static.csv")
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.0, 4.5), sharey=True, constrained_layout=True)
    for name, words in NAMES.items():
        if f"{name}_tension_n" not in table:
            continue
        left.plot(1e-3 * table[f"{name}_tension_n"], table["depth_m"], color=COLOURS[name], label=words)
        if name in ("rotate", "drill"):
            right.plot(1e-3 * table[f"{name}_torque_n_m"], table["depth_m"], color=COLOURS[name], label=words)
    left.axvline(0.0, color="0.5", linewidth=0.6)
    left.set_xlabel("effective tension, kN")
    right.set_xlabel("torque, kN m")
    downward(left, "measured depth, m")
    right.grid(alpha=0.3)
    left.legend(frameon=False)
    return figure


def broomstick(folder):
    """Hook load and torque over the depth of the bit."""
    table = columns_of(folder / "broomstick.csv")
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.0, 4.5), sharey=True, constrained_layout=True)
    for name in ("pull_up", "slack_off", "rotate"):
        left.plot(1e-3 * table[f"{name}_n"], table["bit_depth_m"], color=COLOURS[name], label=NAMES[name])
    right.plot(1e-3 * table["rotate_torque_n_m"], table["bit_depth_m"], color=COLOURS["rotate"])
    left.set_xlabel("hook load, kN")
    right.set_xlabel("surface torque, rotating off bottom, kN m")
    downward(left, "measured depth of the bit, m")
    right.grid(alpha=0.3)
    left.legend(frameon=False)
    return figure


def mode_shapes(folder, summary):
    """Shapes of the first axial and torsional vibrations, with their frequencies."""
    table = columns_of(folder / "modes.csv")
    kinds = [k for k in ("axial", "torsional") if f"{k}_1" in table]
    figure, axes = plt.subplots(1, len(kinds), figsize=(3.5 * len(kinds), 4.5), sharey=True, squeeze=False,
                                constrained_layout=True)
    for ax, kind in zip(axes[0], kinds):
        for k, frequency in enumerate(summary[f"{kind}_frequencies_hz"], 1):
            ax.plot(table[f"{kind}_{k}"], table["depth_m"], label=f"{frequency:.3f} Hz")
        ax.set_xlabel(f"{kind} shape")
        ax.grid(alpha=0.3)
        ax.legend(frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, fontsize=8,
                  handlelength=1.0, columnspacing=1.0)
    downward(axes[0][0], "measured depth, m")
    return figure


def depth_of(labels):
    """Depths that a record has as texts."""
    return np.array([float(text) for text in labels])


def time_depth(folder):
    """Rotary speed and torque over time and depth."""
    import xarray

    with xarray.open_dataset(folder / "string.nc", decode_times=False) as data:
        time = data["time"].values
        nodes, elements = depth_of(data["node_depth"].values), depth_of(data["element_depth"].values)
        speed = data["rotary_speed"].values * 30.0 / np.pi
        torque = 1e-3 * data["torque"].values
    figure, axes = plt.subplots(2, 1, figsize=(7.5, 6.0), sharex=True, constrained_layout=True)
    for ax, depth, values, words, colours in ((axes[0], nodes, speed, "rotary speed, rpm", "viridis"),
                                              (axes[1], elements, torque, "torque, kN m", "magma")):
        map_ = ax.pcolormesh(time, depth, values.T, shading="nearest", cmap=colours, rasterized=True)
        figure.colorbar(map_, ax=ax, label=words)
        ax.invert_yaxis()
        ax.set_ylabel("measured depth, m")
    axes[1].set_xlabel("time, s")
    return figure


def traces(folder):
    """Speed and torque at the surface and at the bit."""
    table = columns_of(folder / "history.csv")
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(7.5, 5.0), sharex=True, constrained_layout=True)
    time = table["time [s]"]
    for ax, names, scale, words in (
            (upper, ("top_speed [rad/s]", "speed [rad/s]"), 30.0 / np.pi, "rotary speed, rpm"),
            (lower, ("surface_torque [N m]", "torque [N m]"), 1e-3, "torque, kN m")):
        for name, label, colour in zip(names, ("surface", "bit"), ("#1b6ca8", "#b3382c")):
            ax.plot(time, scale * table[name], color=colour, linewidth=0.9, label=label)
        ax.set_ylabel(words)
        ax.grid(alpha=0.3)
    upper.legend(frameon=False, ncols=2)
    lower.set_xlabel("time, s")
    return figure


def pictures(folder):
    """Figures of a folder by the name of their file."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    figures = {"torque_and_drag": torque_and_drag(folder), "broomstick": broomstick(folder),
               "modes": mode_shapes(folder, summary)}
    if (folder / "history.csv").is_file():
        figures["traces"] = traces(folder)
    if (folder / "string.nc").is_file():
        figures["time_depth"] = time_depth(folder)
    for figure in figures.values():
        figure.get_layout_engine().set(rect=(0.0, 0.03, 1.0, 0.97))  # the signature is below
    return figures, summary


RPM_OF_STRING_CYCLE = 30.0 / np.pi
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


def string_cycle(inputs):
    """Rotary speed and torque along a drill string over a cycle of stick-slip, from string.nc, with the paths of waves."""
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
    draw_map(upper, time[shown], nodes, RPM_OF_STRING_CYCLE * speed[shown], "rotary speed (rpm)", "viridis")
    draw_map(lower, time[shown], elements, 1e-3 * torque[shown], "torque (kN m)", "magma")
    for axes in (upper, lower):
        for leaves in (stop, start):
            draw_waves(axes, leaves, nodes[-1], wave_speed)
    lower.set_xlabel("time (s)")
    return figure


LENGTH, SHEAR, DENSITY = 2500.0, 79.3e9, 7850.0  # m, Pa, kg/m3: steel string of the case
TRAVEL = LENGTH / math.sqrt(SHEAR / DENSITY)  # s
RPM_OF_STRING_DELAY = 30.0 / math.pi
AROUND = 0.15  # s: means over this time, so that the cutters' chatter does not hide the waves


def smooth(time, values):
    """(time, moving means over AROUND), without the ends, where means lack a part of their time."""
    n = max(1, int(round(AROUND / (time[1] - time[0]))) | 1)
    return time[n // 2:len(time) - n // 2], np.convolve(values, np.ones(n) / n, mode="valid")


def events(time, speed):
    """Times at which the bit comes to rest and starts again."""
    still = speed < STILL * speed.mean()
    change = np.diff(still.astype(int))
    return time[1:][change == 1], time[1:][change == -1]


def string_delay(inputs):
    """Speed and torque of bit B at the surface and at the bit, while the bit sticks: what the bit does shows at the surface a travel time later."""
    folder = inputs.folder("string-delay")
    time, speed, top, surface, torque = results.history(folder, "time", "rotary_speed", "top_speed", "surface_torque", "torque_on_bit")
    figure, (upper, lower) = style.panels(2, 1, (7.5, 5.2), sharex=True)
    upper.plot(time, RPM_OF_STRING_DELAY * top, color=style.BLUE, label="surface")
    upper.plot(time, RPM_OF_STRING_DELAY * speed, color=style.RED, label="bit")
    upper.set(ylabel="rotary speed (rpm)", ylim=(None, 1.25 * RPM_OF_STRING_DELAY * speed.max()))
    upper.legend(loc="upper right", ncols=2)
    lower.plot(time, 1e-3 * surface, color=style.BLUE, label="surface torque")
    lower.plot(*smooth(time, 1e-3 * torque), color=style.RED, label=f"torque on bit, means over {AROUND} s")
    lower.set(xlabel="time (s)", ylabel="torque (kN m)", xlim=(0.0, time[-1]))
    lower.legend(loc="upper right", ncols=2)
    lower.set_ylim(top=1.25 * 1e-3 * surface.max())
    for kind, colour in zip(events(time, speed), (style.BLACK, style.GREEN)):
        for t in kind:
            for axes in (upper, lower):
                axes.axvline(t, color=colour, linestyle=":", linewidth=1.0)
                axes.axvline(t + TRAVEL, color=colour, linestyle="--", linewidth=1.0)
    lower.set_title(f"bit stops (black) and starts (green): dotted; {TRAVEL:.3f} s later, 2500 m at {LENGTH / TRAVEL:.0f} m/s: dashed")
    return figure
