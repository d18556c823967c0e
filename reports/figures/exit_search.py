"""Figure 4.14: the search for where a vertex leaves a part, from plane to plane."""

import numpy as np

from figures import style
from figures.one_step import MM


def draw(inputs):
    if inputs.table("search") is None:
        return style.only_words("the search for an exit")
    rows = inputs.table("search")
    levels = [r for r in rows if r["what"] == "level"]
    [exit_row] = [r for r in rows if r["what"] == "exit"]
    tau, t = np.array([r["tau"] for r in levels]), MM * np.array([r["t"] for r in levels])
    plane = np.array([r["plane"] for r in levels])
    figure, axes = style.panels(1, 1, (7.0, 4.4))
    whole = np.array([0.0, 1.0])
    for k, row in enumerate(r for r in rows if r["what"] == "plane"):
        if row["up"] > 1e-12:
            line = MM * (row["rest"] - row["along"] * whole) / row["up"]
            axes.plot(whole, line, color=style.BLUE if k in plane else "0.8", linewidth=1.0 if k in plane else 0.7, zorder=1)
    axes.fill_between(tau, 0, t, color=style.SKY, alpha=0.25, linewidth=0)
    axes.plot(tau, t, color=style.BLACK, linewidth=2.2)
    top = np.argmax(t)
    axes.plot(tau[top], MM * exit_row["t"], "o", color=style.RED, markersize=7, zorder=5)
    axes.annotate("exit found by the search", (tau[top], MM * exit_row["t"]), xytext=(0, 14),
                  textcoords="offset points", ha="center", color=style.RED, bbox={"color": "white", "pad": 1.5})
    axes.axvspan(exit_row["from"], exit_row["to"], ymax=0.02, color=style.GOLD)
    axes.plot([], [], color=style.GOLD, linewidth=4, label="when the vertex itself is inside")
    axes.plot([], [], color=style.BLUE, label="planes that bound the exit"), axes.plot([], [], color="0.8", label="other planes")
    axes.plot([], [], color=style.BLACK, linewidth=2.2, label="where the ray at that time leaves the part")
    axes.set(xlim=(0, 1), ylim=(0, 1.6 * t.max()), xlabel="fraction of the step, tau", ylabel="distance along the update direction, t (mm)")
    axes.legend(loc="center", bbox_to_anchor=(0.5, 0.3), ncol=1)
    return figure
