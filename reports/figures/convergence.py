"""A study of `tdbd converge`: the errors of every variable over the quantity that was divided."""

import numpy as np

from figures import results, style

COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD, style.SKY, style.BLACK, style.GREY)
MARKERS = "os^Dv<>P"


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


def label(name, variable):
    return f"{name.replace('_', ' ')}: {results.in_words(variable, digits=3)}"


def draw_folder(folder):
    """Both axes are logarithmic; the legend gives the observed orders."""
    study = results.read_json(folder, "convergence.json")
    kind = "errors" if study["against"] == "reference" else "differences"
    lines = {name: scaled_errors(v, kind) for name, v in study["variables"].items()}
    sizes = np.array([level["size"] for level in study["levels"]])[:len(next(iter(lines.values()), []))]
    figure, axes = style.panels(1, 1, (8.0, 4.8))
    for i, (name, errors) in enumerate(lines.items()):
        axes.loglog(sizes, errors, color=COLOURS[i % len(COLOURS)], marker=MARKERS[i % len(MARKERS)],
                    label=label(name, study["variables"][name]))
    if (nominal := nominal_line(sizes, lines.values(), study["nominal_order"], study["floor"])) is not None:
        axes.loglog(sizes, nominal, color=style.GREY, linestyle="dashed", label=f"order {study['nominal_order']:g}, nominal")
    against = "the reference" if kind == "errors" else "the next level"
    axes.set(xlabel=f"{study['over']} ({'s' if study['over'] == 'time.step' else 'SI'})",
             ylabel=f"{kind} to {against}, over the variable's size", title=f"{study['title'] or 'convergence'}: {kind} over {study['over']}")
    axes.legend(title="variable: observed order", loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure
