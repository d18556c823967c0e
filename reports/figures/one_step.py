"""The table one-step: a cutter at two poses, its motion box, the rock's vertices near it. Lengths in mm."""

import numpy as np
from matplotlib.patches import Polygon, Rectangle

from figures import style

MM = 1e3
MAGENTA = "#d6139a"
STATES = (("passed over by the search", "0.75", 4), ("offered by it, not swept", style.BLUE, 8), ("swept by the cutter", style.RED, 11))


def xy(points):
    return np.asarray(points)[..., :2]


def rz(points):
    """Radius and depth."""
    points = np.asarray(points)
    return np.stack([np.hypot(points[..., 0], points[..., 1]), points[..., 2]], axis=-1)


def hull(points):
    """Corners of the convex hull of points in a plane, in order: one chain from left to right, one back."""
    corners = []
    for chain in (np.unique(points, axis=0), np.unique(points, axis=0)[::-1]):
        start = len(corners)
        for p in chain:
            while len(corners) > start + 1 and turn(corners[-2], corners[-1], p) <= 0:
                corners.pop()
            corners.append(p)
        corners.pop()
    return np.array(corners)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Step:
    """What the table says, as arrays."""

    def __init__(self, rows):
        vertices = [r for r in rows if r["what"] == "vertex"]
        self.start, self.end = (MM * np.array([v[k] for v in vertices]) for k in ("from", "to"))
        self.direction = np.array([v["direction"] for v in vertices])
        self.state = np.array([2 if v["moved"] else int(v["candidate"]) for v in vertices])
        self.cutter = [MM * np.array([r["corners"] for r in rows if r["what"] == "part" and r["pose"] == k]).reshape(-1, 3)
                       for k in (0, 1)]
        [box] = [r for r in rows if r["what"] == "box"]
        self.box = MM * np.array([box["low"], box["high"]])

    def draw_cutter(self, axes, plane, pose, **look):
        outline = plane(self.cutter[pose])
        axes.add_patch(Polygon(hull(outline), **look))

    def draw_both(self, axes, plane):
        self.draw_cutter(axes, plane, 0, facecolor="none", edgecolor=style.GREY, linestyle="--", linewidth=1.0)
        self.draw_cutter(axes, plane, 1, facecolor="0.88", edgecolor=style.BLACK, linewidth=1.0, alpha=0.7, zorder=0)

    def draw_vertices(self, axes, plane):
        for state, (_, colour, size) in enumerate(STATES):
            axes.scatter(*plane(self.start[self.state == state]).T, s=size, color=colour, linewidths=0, zorder=2 + state)

    def draw_box(self, axes):
        low, high = self.box[:, :2]
        axes.add_patch(Rectangle(low, *(high - low), fill=False, edgecolor=style.GOLD, linewidth=1.6))


def name_planes(above, section):
    above.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
    above.invert_yaxis()
    above.set_title("from above the hole", loc="left")
    section.set(xlabel="distance from the axis of the hole (mm)", ylabel="z (mm, down)", aspect="equal")
    section.invert_yaxis()
    section.set_title("turned into one half-plane through the axis", loc="left")


def legend_below(figure, handles):
    figure.get_layout_engine().set(rect=(0, 0.11, 1, 0.89))
    figure.legend(handles=handles, loc="lower center", ncol=3)
