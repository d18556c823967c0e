"""Share of time in which cutters move backward and sideways in whirl, over their radius."""

import numpy as np

from figures import style


def draw(inputs):
    rows = inputs.table("whirl-motion")
    if rows is None:
        return style.only_words("Backward travel")
    figure, axes = style.panels(1, 1, (6.4, 3.8))
    r = [row["r_over_gage"] for row in rows]
    line = np.linspace(0.0, 1.0, 401)
    axes.plot(line, np.arccos(line) / np.pi, color=style.GREY, label="arccos(r/R)/$\\pi$")
    axes.plot(r, [row["backward"] for row in rows], "o", color=style.RED, label="backward")
    axes.plot(r, [row["sideways"] for row in rows], "s", color=style.BLUE, label="sideways rather than along")
    axes.set(xlabel="radius of the cutter over that of the bit", ylabel="share of time", xlim=(0.0, 1.02), ylim=(0.0, 0.6))
    axes.legend(loc="lower left")
    return figure
