"""Figure 4.10: the directions in which teeth of a roller cone bit move rock, by place on the tooth."""

import numpy as np
from matplotlib.patches import Polygon

from figures import style
from figures.one_step import MAGENTA, MM, hull, rz


def side(rows):
    """Facets that face outward or down: the only ones that meet rock ahead of them."""
    corners = np.array([r["corners"] for r in rows])
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middle = corners.mean(axis=1)
    outward = (normal[:, :2] * middle[:, :2]).sum(axis=1)
    return (normal[:, 2] > 0) | (outward > 0)


def draw_tooth(axes, rows, title):
    outline = MM * rz(np.array([r["corners"] for r in rows]).reshape(-1, 3))
    axes.add_patch(Polygon(hull(outline), facecolor="0.9", edgecolor=style.BLACK))
    place, direction = (np.array([r[k] for r in rows])[side(rows)] for k in ("place", "direction"))
    azimuth = np.arctan2(place[:, 1], place[:, 0])
    outward = direction[:, 0] * np.cos(azimuth) + direction[:, 1] * np.sin(azimuth)
    axes.quiver(*(MM * rz(place)).T, outward, direction[:, 2], color=MAGENTA, angles="xy", scale_units="xy", scale=0.4, width=0.004)
    axes.set(xlabel="distance from the bit's axis (mm)", ylabel="z (mm, down)", aspect="equal")
    axes.set_title(title, loc="left")
    low, high = outline.min(axis=0), outline.max(axis=0)
    axes.set(xlim=(low[0] - 2, high[0] + 4), ylim=(high[1] + 4, low[1] - 2))


def draw(inputs):
    if inputs.table("tooth-directions") is None:
        return style.only_words("directions at teeth")
    rows = inputs.table("tooth-directions")
    figure, frames = style.panels(1, 2, (8.6, 4.6))
    for axes, name in zip(frames, ("inner row", "gage row")):
        draw_tooth(axes, [r for r in rows if r["tooth"] == name], f"a tooth of an {name}" if name[0] == "i" else "a tooth of the gage row")
    return figure
