"""Mean speed of the cones over the bit's, by model, over the advance."""

from figures import style
from figures.compare_models import legend, look, title


def draw(results):
    runs = results.get("bit-r", [])
    figure, axes = style.panels(1, 1, (7.2, 4.2))
    for model in dict.fromkeys(m for _, r in runs for m in r.titles):
        shown = [(1e3 * r.advance, r.value(model, "cone_speed_ratio")) for _, r in runs if r.value(model, "cone_speed_ratio") is not None]
        if shown:
            axes.plot(*zip(*shown), "-", linewidth=0.8, label=title(results, model), **look(model))
    axes.set(xlabel="advance (mm a revolution)", ylabel="speed of the cones over the bit's", xlim=(0.0, None))
    legend(axes, "Cones")
    return figure
