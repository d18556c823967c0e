"""Studies of convergence of the whole program: drilling along a path and under forces, and a top."""

import numpy as np

from figures import results, style

# run of the manifest: (title, what is divided)
STUDIES = {
    "converge-steps": ("bit B at a given rate, over the step", "step (s)"),
    "converge-edges": ("bit B at a given rate, over the edges", "edge length (m)"),
    "converge-both": ("bit B moved by forces, over both", "edge length (m); steps with it"),
    "converge-top": ("the slow top, over the step", "step (s)"),
}
DRILLING = {"wob_mean": style.BLUE, "tob_mean": style.RED, "removed_volume": style.GREEN, "removed_volume_by_cutter": style.SKY,
            "surface_distance": style.BLACK, "volume_between": style.GOLD, "position": style.PURPLE}
TOP = {"attitude": style.BLUE, "body_momentum": style.RED, "space_momentum": style.PURPLE, "angular_velocity": style.GREEN,
       "energy": style.GOLD}
MARKERS = "os^Dv<>"


def label(name, variable):
    """Observed order, or the slope of all differences where it has not settled; relative uncertainty of the finest level."""
    order = results.in_words(variable) if variable["order"] is not None else f"({variable['order_of_all']:.1f})"
    uncertainty = variable["uncertainty"]["value"] / variable["scale"]
    return f"{name.replace('_', ' ')}: {order}, ±{uncertainty:.0e}"


def draw_study(axes, folder, title, quantity):
    study = results.read_json(folder, "convergence.json")
    wanted = TOP if study["levels"][0]["state"].keys() >= TOP.keys() else DRILLING
    for marker, (name, colour) in zip(MARKERS, wanted.items()):
        if (variable := study["variables"].get(name)) is None:
            continue
        differences = np.array(variable["differences"]) / variable["scale"]
        sizes = np.array([level["size"] for level in study["levels"]])[:len(differences)]
        axes.loglog(sizes, np.where(differences > 0, differences, np.nan), color=colour, marker=marker, label=label(name, variable))
    axes.set(title=title, xlabel=quantity)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * (high / low) ** 0.5)  # room for the legend
    axes.legend(fontsize=7, loc="upper left", title="order (slope of all if not settled), uncertainty", title_fontsize=7)


def draw(inputs):
    figure, grid = style.panels(2, 2, (11.0, 8.6))
    for axes, (run, words) in zip(grid.flat, STUDIES.items()):
        draw_study(axes, inputs.folder(run), *words)
    for row in grid:
        row[0].set_ylabel("difference to the next level, over the variable's size")
    return figure
