"""Figure 4.12: the update direction of a cutter, turned to the azimuth of each vertex, and where vertices went."""

import numpy as np

from figures import style
from figures.one_step import MAGENTA, Step, legend_below, name_planes, rz, xy


def draw(inputs):
    if inputs.table("one-step") is None:
        return style.only_words("one step of one cutter")
    step = Step(inputs.table("one-step"))
    moved = step.state == 2
    start, end, direction = step.start[moved], step.end[moved], step.direction[moved]
    figure, (above, section) = style.panels(1, 2, (10.4, 5.2))
    for axes, plane in ((above, xy), (section, rz)):
        step.draw_both(axes, plane)
        axes.scatter(*plane(start).T, s=9, color=style.RED, linewidths=0, zorder=4)
        axes.scatter(*plane(end).T, s=9, color=style.BLUE, linewidths=0, zorder=4)
        way = plane(end) - plane(start)
        axes.quiver(*plane(start).T, *way.T, angles="xy", scale_units="xy", scale=1, color=MAGENTA, width=0.0025, zorder=3)
    name_planes(above, section)
    frame_around(above, xy(np.concatenate([start, end])), 3.0)
    frame_around(section, rz(np.concatenate([start, end])), 3.0)
    section.text(0.02, 0.02, f"turned back by their azimuths\nall directions then agree to {spread(start, direction):.0e} rad",
                 transform=section.transAxes, va="bottom", fontsize=8)
    handles = [above.scatter([], [], s=20, color=style.RED, label="swept vertex before"),
               above.scatter([], [], s=20, color=style.BLUE, label="the same, moved to the exit"),
               *above.plot([], [], color=MAGENTA, label="its path along the mapped update direction")]
    legend_below(figure, handles)
    return figure


def frame_around(axes, points, margin):
    (left, low), (right, high) = points.min(axis=0) - margin, points.max(axis=0) + margin
    axes.set(xlim=(left, right), ylim=(high, low))


def spread(start, direction):
    """Largest angle between the directions in the vertices' own half-planes, rad: the bit's axis is the hole's."""
    azimuth = np.arctan2(start[:, 1], start[:, 0])
    outward = direction[:, 0] * np.cos(azimuth) + direction[:, 1] * np.sin(azimuth)
    angle = np.arctan2(outward, direction[:, 2])
    return max(np.ptp(angle), 1e-16)
