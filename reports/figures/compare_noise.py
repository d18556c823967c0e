"""Noise of one step's torque over the CPU time of a simulated second."""

from figures import style
from figures.compare_models import legend

# group: (model, quantity, label, colour, marker, line)
SERIES = {
    "noise-mesh": [("tdbd", "torque_noise", "TDBD, sections", style.BLACK, "o", "-")],
    "noise-volumes": [("tdbd", "torque_noise", "TDBD, volumes", style.BLACK, "o", ":")],
    "noise-planes": [("behr", "torque_noise_by_crossing", "Behr et al., by crossing", style.RED, "^", "-")],
    "noise-spokes": [("langeveld", "torque_noise_by_crossing", "Langeveld, by crossing", style.BLUE, "v", "-")],
    "noise-outlines": [("hanson-hansen", "torque_noise", "Hanson and Hansen, spread", style.GREEN, "s", ":"),
                       ("hanson-hansen", "torque_noise_by_crossing", "Hanson and Hansen, by crossing", style.GREEN, "s", "-")],
}
LEAST = 1e-6  # less noise than this is rounding


def points(runs, model, quantity):
    """[(cost, noise, what was refined)]."""
    found = [(r.cost(model), r.value(model, quantity), list(settings.values())[-1]) for settings, r in runs if model in r.titles]
    return [p for p in found if p[0] and p[1] is not None and p[1] > LEAST]


def draw(results):
    figure, axes = style.panels(1, 1, (7.6, 4.8))
    for group, series in SERIES.items():
        for model, quantity, label, colour, marker, line in series:
            shown = points(results.get(group, []), model, quantity)
            if not shown:
                continue
            cost, noise, refined = zip(*shown)
            axes.loglog(cost, [100.0 * n for n in noise], line, color=colour, marker=marker, label=label)
            for x, y, word in (shown[0], shown[-1]):
                axes.annotate(str(word), (x, 100.0 * y), textcoords="offset points", xytext=(4, 4), fontsize=7, color=colour)
    axes.set(xlabel="CPU time over simulated time", ylabel="noise of the torque (%)")
    legend(axes, "Noise")
    return figure
