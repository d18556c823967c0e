"""Figures 4.23 and 4.24: the prism between an old and a new triangle, in space and in its own coordinates."""

import numpy as np
from matplotlib.ticker import MaxNLocator

from figures import style

MM = 1e3
GAUSS = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0)  # of zeta; the weight of each is a half of the prism's


def largest(rows):
    """Old and new corners of the triangle that swept most of those of which all three corners moved; mm."""
    whole = [r for r in rows if all(a != b for a, b in zip(r["from"], r["to"]))]
    best = max(whole or rows, key=lambda r: r["volume"])
    return MM * np.array(best["from"]), MM * np.array(best["to"]), best["volume"]


def at(old, new, xi, eta, zeta):
    """x = (1 - zeta) x_old(xi, eta) + zeta x_new(xi, eta)."""
    weights = np.array([1 - xi - eta, xi, eta])
    return (1 - zeta) * weights @ old + zeta * weights @ new


def draw_prism(axes, old, new, names):
    for corners, colour in ((old, style.GREY), (new, style.BLUE)):
        closed = np.vstack([corners, corners[:1]])
        axes.plot(*closed.T, color=colour, linewidth=2.0)
    for a, b in zip(old, new):
        axes.plot(*np.stack([a, b]).T, color=style.BLACK, linewidth=0.9, linestyle="--")
    for share in (0.25, 0.5, 0.75):  # the sides between are ruled
        for k in range(3):
            j = (k + 1) % 3
            line = np.stack([(1 - share) * old[k] + share * old[j], (1 - share) * new[k] + share * new[j]])
            axes.plot(*line.T, color="0.7", linewidth=0.6)
    points = np.array([at(old, new, 1 / 3, 1 / 3, z) for z in GAUSS])
    axes.scatter(*points.T, color=style.RED, s=26, depthshade=False)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_major_locator(MaxNLocator(4))
    axes.set(xlabel=names[0], ylabel=names[1], zlabel=names[2])


def draw(inputs):
    if inputs.table("prisms") is None:
        return style.only_words("prisms of a step")
    old, new, volume = largest(inputs.table("prisms"))
    figure = style.Figure(figsize=(10.0, 4.8))
    space = figure.add_subplot(1, 2, 1, projection="3d")
    draw_prism(space, old, new, ("x (mm)", "y (mm)", "z (mm, down)"))
    space.set_aspect("equal")
    space.set_zlim(*reversed(space.get_zlim()))
    space.set_title(f"in space: {1e9 * volume:.3f} mm$^3$ of rock removed")
    own = figure.add_subplot(1, 2, 2, projection="3d")
    flat = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    draw_prism(own, np.column_stack([flat, np.zeros(3)]), np.column_stack([flat, np.ones(3)]), ("xi", "eta", "zeta"))
    own.set_title("in its own coordinates")
    for colour, words in ((style.GREY, "old triangle, zeta = 0"), (style.BLUE, "new triangle, zeta = 1"), (style.RED, "Gauss points")):
        space.plot([], [], [], "s", color=colour, label=words)
    figure.legend(*space.get_legend_handles_labels(), loc="lower center", ncol=3)
    figure.subplots_adjust(left=0.02, right=0.95, bottom=0.14, top=0.92, wspace=0.12)
    return figure
