"""Forces of every cutter in steady drilling: faces, chamfers, power."""

import numpy as np

from figures import results, style


def of_parts(summary, kind):
    """{cutter number: part figures} of the parts of a kind."""
    found = {}
    for part in summary["forces"]:
        cutter, _, what = part["name"].partition("/")
        if what == kind and cutter.startswith("cutter-"):
            found[int(cutter.removeprefix("cutter-"))] = part
    return found


def bars(axes, numbers, parts, key, scale, style_of):
    label, colour, bottom = style_of
    heights = np.array([scale * parts[n][key] if n in parts else 0.0 for n in numbers])
    axes.bar(numbers, heights, bottom=bottom, color=colour, label=label, width=0.8)
    return heights


def draw(inputs):
    return draw_summary(results.summary(inputs.folder("forces-b")))


def draw_summary(summary):
    """Of any run with forces of a bit with cutters."""
    faces, chamfers = of_parts(summary, "face"), of_parts(summary, "chamfer")
    numbers = np.array(sorted(faces | chamfers))
    figure, axes = style.panels(3, 1, (7.0, 6.4), sharex=True)
    for panel, key, scale, label in ((axes[0], "normal_mean_n", 1e-3, "normal force (kN)"),
                                     (axes[1], "tangential_mean_n", 1e-3, "tangential force (kN)"),
                                     (axes[2], "power_mean_w", 1e-3, "power (kW)")):
        below = bars(panel, numbers, faces, key, scale, ("face", style.BLUE, 0.0))
        bars(panel, numbers, chamfers, key, scale, ("chamfer", style.GOLD, below))
        panel.set_ylabel(label)
    axes[0].legend(loc="upper right")
    axes[2].set_xlabel("cutter, from the axis outwards")
    return figure
