"""Pictures of a folder of tdbd string: torque and drag, broomstick plot, mode shapes, time-depth maps."""

import csv
import json

import matplotlib.pyplot as plt
import numpy as np

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
        figure.get_layout_engine().set(rect=(0.0, 0.03, 1.0, 0.97))  # the signature stands below
    return figures, summary
