"""The figure of zijsling-pressures: drag, and the ratio of the force into the rock to drag, over
pressure.

It shows what a law's dependence on pressure can represent."""

import csv

import figures
import style  # figures has added its folder to the path

NAME = "zijsling-pressures"
FITTED_MPA = (15.0, 45.0)  # the range of the fitted pressures


def points(folder, thickest):
    """[(pressure MPa, drag kN, force over drag)] of fitted and predicted rows at one depth: by law, and measured."""
    rows = []
    for file in ("residuals.csv", "predictions.csv"):
        with (folder / file).open(newline="", encoding="utf-8") as text:
            rows += list(csv.DictReader(text))
    depths = sorted({float(r["depth [m]"]) for r in rows})
    rows = [r for r in rows if float(r["depth [m]"]) == depths[-1 if thickest else 0]]
    def line(normal, drag):
        return sorted((float(r["pressure [Pa]"]) * 1e-6, float(r[drag]) * 1e-3, float(r[normal]) / float(r[drag])) for r in rows)
    return line("normal_mean [N]", "drag_mean [N]"), line("measured_normal [N]", "measured_drag [N]")


def draw(results, comparison):
    """The laws of the comparison over pressure, for the thicker cuts."""
    figure, (drag, ratio) = style.panels(1, 2, (8.6, 3.9))
    for axes in (drag, ratio):
        axes.axvspan(*FITTED_MPA, color="0.93", linewidth=0, label="fitted pressures")
        axes.set(xlabel="pressure at the bottom of the hole (MPa)")
    for (law, how), (colour, _), dashes in zip(comparison["law"].items(), figures.LOOKS, ("-", "--", "-")):
        by_law, model = points(results / how["case"], thickest=True)
        drag.plot([p for p, _, _ in by_law], [d for _, d, _ in by_law], dashes, color=colour, label=law)
        ratio.plot([p for p, _, _ in by_law], [r for _, _, r in by_law], dashes, color=colour)
    drag.plot([p for p, _, _ in model], [d for _, d, _ in model], "o", color=style.BLACK, label="published model")
    ratio.plot([p for p, _, _ in model], [r for _, _, r in model], "o", color=style.BLACK)
    drag.set(ylabel="drag of a cut of 3 mm2 (kN)", ylim=(0, None))
    ratio.set(ylabel="force into the rock over drag")
    drag.legend(loc="upper left")
    figure.suptitle("Published model (Miedema after Zijsling 1987), not measurements", fontsize=8.5)
    return figure


def draw_all(results, split):
    """Writes pressures.png if the comparison is one of those that were computed."""
    for comparison in split:
        if comparison["name"] == NAME:
            figures.save(draw(results, comparison), results / "pressures.png")
