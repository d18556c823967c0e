"""Figure 4.6: which cutters are inside and which outside, and where each moves rock."""

import numpy as np

from figures import bit_charts, bit_data, style

LENGTH = 9.0  # mm, of an arrow


def in_half_plane(vector, place):
    """(r, z) of a vector at the azimuth of a place."""
    outward = np.array([*place[:2], 0.0]) / np.hypot(*place[:2])
    return np.dot(vector, outward), vector[2]


def arrow(axes, start, direction, colour, width=0.0035):
    axes.quiver(*start, *(LENGTH * np.array(direction) / np.hypot(*direction)), color=colour, angles="xy",
                scale_units="xy", scale=1.0, width=width, zorder=3)


def draw(inputs):
    bit = bit_data.read(inputs.only_folder())
    own = {p["cutter"]: p["update_direction"] for p in bit.parts if p["cutter"] >= 0}
    figure, axes = style.panels(1, 1, (7.6, 4.6))
    for k, cutter in enumerate(bit.cutters):
        r, z = bit_charts.rz(cutter["outline_rz_m"])
        exposure = in_half_plane(-np.array(cutter["z_axis"]), cutter["face_centre_m"])
        colour = style.BLUE if exposure[0] > 0 else style.GREEN
        axes.fill(r, z, facecolor=colour, edgecolor=colour, alpha=0.15)
        arrow(axes, bit_charts.rz([(np.hypot(*cutter["face_centre_m"][:2]), cutter["face_centre_m"][2])]), exposure, style.GREY)
        arrow(axes, bit_charts.rz([(cutter["tip_radius_m"], cutter["tip_m"][2])]), own[k][::2], "#d6139a", 0.005)
    for colour, words in ((style.GREEN, "inside cutters"), (style.BLUE, "outside cutters"),
                          (style.GREY, "-Z of the cutter's frame"), ("#d6139a", "update direction")):
        axes.plot([], [], "s", color=colour, label=words)
    bit_charts.half_plane(axes)
    bit_charts.show_cutters(axes, bit)
    axes.set_ylim(axes.get_ylim()[0] + LENGTH, axes.get_ylim()[1])
    axes.set_xlim(axes.get_xlim()[0], axes.get_xlim()[1] + LENGTH)
    axes.legend(loc="upper left")
    return figure
