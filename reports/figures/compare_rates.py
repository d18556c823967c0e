"""Rate of penetration over weight, by model: drag bits and the roller cone bit."""

from figures import style
from figures.compare_models import legend, look, title

PANELS = {"bit-b": "Bit B (fixed cutters)", "bit-r": "The roller cone bit of the comparison"}


def points(runs, model):
    """[(weight kN, rate m/h)]: of its own weight at the case's rate, or of its rate at the reference weight."""
    found = set()
    for _, result in runs:
        weight, rate = result.value(model, "weight"), result.value(model, "rate_at_weight")
        if weight is not None:
            speed = result.advance * result.info["rotary_speed_rad_per_s"] / 6.283185307179586
            found.add((1e-3 * weight, 3600.0 * speed))
        elif rate is not None:
            found.add((1e-3 * result.info["reference_weight_n"], 3600.0 * rate))
    return sorted(found)


def draw(results):
    groups = [g for g in PANELS if g in results]
    figure, panels = style.panels(1, max(1, len(groups)), (10.2, 4.2), squeeze=False)
    for axes, group in zip(panels[0], groups):
        for model in dict.fromkeys(m for _, r in results[group] for m in r.titles):
            if shown := points(results[group], model):
                weight, rate = zip(*shown)
                axes.plot(weight, rate, "-", linewidth=0.8, label=title(results, model), **look(model))
        axes.set(title=PANELS[group], xlabel="weight (kN)", ylabel="rate of penetration (m/h)", xlim=(0.0, None), ylim=(0.0, None))
        legend(axes, "Rates")
    return figure
