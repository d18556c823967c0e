"""Wear flats over the radius, by model."""

from figures import style
from figures.compare_models import legend, look


def draw(results):
    figure, axes = style.panels(1, 1, (7.2, 4.0))
    runs = results.get("bit-b", [])
    for _, result in runs[len(runs) // 2:][:1]:
        for model, title in result.titles.items():
            if flats := sorted(result.parts(model, "wear_flat").values()):
                axes.plot([1e3 * r for r, _ in flats], [1e6 * a for _, a in flats], linestyle="none", label=title, **look(model))
    axes.set(xlabel="radius of the tip (mm)", ylabel="wear flat (mm²)")
    legend(axes, "Wear")
    return figure
