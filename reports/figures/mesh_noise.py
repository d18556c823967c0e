"""Noise of bit A's torque over the edge of the rock's mesh, and its traces, with cutters meshed in three ways."""

import numpy as np

from figures import style

CUTTERS = {"graded": (style.BLUE, "o"), "even 2 mm": (style.RED, "s"), "even 4 mm": (style.GREEN, "^")}
FORCES = {"volume": "-", "section": ":"}


def draw_noise(axes, rows):
    for (cutters, (colour, marker)), (forces, line) in ((c, f) for f in FORCES.items() for c in CUTTERS.items()):
        shown = [r for r in rows if r["motion"] == "given rate" and r["cutters"] == cutters and r["forces"] == forces]
        axes.loglog([1e3 * r["rock_edge_m"] for r in shown], [100.0 * r["noise"] for r in shown], line, color=colour, marker=marker,
                    markersize=6 if cutters == "graded" else 4, fillstyle="none" if cutters == "graded" else "full",
                    label=f"{forces}s, cutters {cutters}")
    edges = np.array([1.0, 4.0])
    axes.loglog(edges, 3.0 * edges**1.8, "--", color=style.GREY, label="power 1.8")
    axes.set(title="At a given rate", xlabel="edge of the rock's mesh (mm)", ylabel="torque: rms about its mean, over it (%)",
             ylim=(0.05, 200.0))
    axes.set_xticks([1.0, 1.4, 2.0, 2.8, 4.0], ["1", "1.4", "2", "2.8", "4"])
    axes.set_yticks([0.1, 1.0, 10.0, 100.0], ["0.1", "1", "10", "100"])
    axes.minorticks_off()
    axes.legend(fontsize=7, ncols=2, loc="upper left")


def draw_traces(axes, traces):
    for trace in traces:
        torque = 1e-3 * np.array(trace["torque_n_m"])
        colour, _ = CUTTERS[trace["cutters"]]
        axes.plot(1e3 * trace["step_s"] * np.arange(len(torque)), torque, color=colour, linewidth=0.8,
                  label=trace["cutters"] if trace["forces"] == "volume" else None)
    axes.set(xlabel="time (ms)", ylabel="torque (kN m)")


def draw(inputs):
    rows, traces = inputs.table("mesh-noise"), inputs.table("mesh-noise-traces")
    if rows is None or traces is None:
        return style.only_words("Noise of meshes")
    figure = style.Figure(figsize=(10.0, 5.2), layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=(1.0, 1.1))
    draw_noise(left.subplots(), rows)
    axes = right.subplots(2, 1, sharex=True)
    for at, forces in zip(axes, FORCES):
        draw_traces(at, [t for t in traces if t["forces"] == forces])
        at.set_title(f"Moved by forces, from {forces}s; rock of 2 mm")
    axes[0].set(xlabel="", ylim=(1.1, 3.3))
    axes[0].legend(title="cutters", ncols=3, loc="upper right", fontsize=7, title_fontsize=7)
    return figure
