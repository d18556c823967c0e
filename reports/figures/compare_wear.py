"""Wear flats over the radius, by model."""

from figures import style
from figures.compare_models import look


def draw(results):
    figure, axes = style.panels(1, 1, (7.2, 4.0))
    worn = {}
    if "bit-b" in results:
        _, result = results["bit-b"][1]
        worn = {m: sorted(result.parts(m, "wear_flat").values()) for m in result.titles}
    for model, flats in worn.items():
        if flats:
            axes.plot([1e3 * r for r, _ in flats], [1e6 * a for _, a in flats], linestyle="none", label=result.titles[model], **look(model))
    axes.set(xlabel="radius of the tip (mm)", ylabel="wear flat (mm²)")
    if any(worn.values()):
        axes.legend()
    else:
        style.say_missing(axes, "Wear")
    return figure
