"""Studies of `tdbd converge`: errors of every variable over the quantity that was refined."""

import numpy as np

from figures import results, style, traces

# A study of `tdbd converge`: the errors of every variable over the quantity that was divided.

COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD, style.SKY, style.BLACK, style.GREY)
MARKERS_OF_CONVERGENCE = "os^Dv<>P"


def scaled_errors(variable, kind):
    """Errors over the variable's scale; NaN where that has no logarithm."""
    errors = np.array(variable[kind], dtype=float) / (variable["scale"] or np.nan)
    return np.where(errors > 0.0, errors, np.nan)


def nominal_line(sizes, lines, order, floor):
    """The method's order, below the least error that is not rounding. None without such an error."""
    points = [(e, s) for errors in lines for s, e in zip(sizes, errors) if e > floor]
    if not points or not order:
        return None
    least, at = min(points)
    return 0.4 * least * (sizes / at) ** order


def label_with_order(name, variable):
    return f"{name.replace('_', ' ')}: {results.in_words(variable, digits=3)}"


def draw_folder(folder):
    """Both axes are logarithmic; the legend gives the observed orders."""
    study = results.read_json(folder, "convergence.json")
    kind = "errors" if study["against"] == "reference" else "differences"
    lines = {name: scaled_errors(v, kind) for name, v in study["variables"].items()}
    sizes = np.array([level["size"] for level in study["levels"]])[:len(next(iter(lines.values()), []))]
    figure, axes = style.panels(1, 1, (8.0, 4.8))
    for i, (name, errors) in enumerate(lines.items()):
        axes.loglog(sizes, errors, color=COLOURS[i % len(COLOURS)], marker=MARKERS_OF_CONVERGENCE[i % len(MARKERS_OF_CONVERGENCE)],
                    label=label_with_order(name, study["variables"][name]))
    if (nominal := nominal_line(sizes, lines.values(), study["nominal_order"], study["floor"])) is not None:
        axes.loglog(sizes, nominal, color=style.GREY, linestyle="dashed", label=f"order {study['nominal_order']:g}, nominal")
    against = "the reference" if kind == "errors" else "the next level"
    axes.set(xlabel=f"{study['over']} ({'s' if study['over'] == 'time.step' else 'SI'})",
             ylabel=f"{kind} to {against}, over the variable's size")
    figure.suptitle(traces.fitted(f"{study['title'] or 'convergence'}: {kind} over {study['over']}", figure), fontsize=10)
    axes.legend(title="variable: observed order", loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


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
MARKERS_OF_WHOLE_CONVERGENCE = "os^Dv<>"


def label_of_study(name, variable):
    """Observed order, or the slope of all differences where it has not settled; relative uncertainty of the finest level."""
    order = results.in_words(variable) if variable["order"] is not None else f"({variable['order_of_all']:.1f})"
    uncertainty = variable["uncertainty"]["value"] / variable["scale"]
    return f"{name.replace('_', ' ')}: {order}, ±{uncertainty:.0e}"


def draw_study(axes, folder, title, quantity):
    study = results.read_json(folder, "convergence.json")
    wanted = TOP if study["levels"][0]["state"].keys() >= TOP.keys() else DRILLING
    for marker, (name, colour) in zip(MARKERS_OF_WHOLE_CONVERGENCE, wanted.items()):
        if (variable := study["variables"].get(name)) is None:
            continue
        differences = np.array(variable["differences"]) / variable["scale"]
        sizes = np.array([level["size"] for level in study["levels"]])[:len(differences)]
        axes.loglog(sizes, np.where(differences > 0, differences, np.nan), color=colour, marker=marker, label=label_of_study(name, variable))
    axes.set(title=title, xlabel=quantity)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * (high / low) ** 0.5)  # room for the legend
    axes.legend(fontsize=7, loc="upper left", title="order (slope of all if not settled), uncertainty", title_fontsize=7)


def whole_convergence(inputs):
    """Studies of convergence of the whole program: drilling along a path and under forces, and a top."""
    figure, grid = style.panels(2, 2, (11.0, 8.6))
    for axes, (run, words) in zip(grid.flat, STUDIES.items()):
        draw_study(axes, inputs.folder(run), *words)
    for row in grid:
        row[0].set_ylabel("difference to the next level, over the variable's size")
    return figure
