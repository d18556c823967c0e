"""Area that each cutter cuts over its radius, by model; a panel for each drag bit."""

from figures import style
from figures.compare_models import legend, look

BITS = {"bit-a": "Bit A", "bit-b": "Bit B", "bit-c": "Bit C"}


def draw(results):
    bits = {group: results[group] for group in BITS if group in results}
    figure, panels = style.panels(1, max(1, len(bits)), (10.2, 3.9), sharey=True, squeeze=False)
    for axes, (group, runs) in zip(panels[0], bits.items()):
        _, result = runs[-1]
        for model, title in result.titles.items():
            areas = sorted(result.parts(model, "area").values())
            if areas:
                axes.plot([1e3 * r for r, _ in areas], [1e6 * a for _, a in areas], linestyle="none", label=title, **look(model))
        axes.set(title=f"{BITS[group]}, {1e3 * result.advance:.3g} mm/rev", xlabel="radius of the tip (mm)", ylim=(0.0, None))
    panels[0, 0].set_ylabel("area cut (mm²)")
    legend(panels[0, -1], "Areas")
    return figure
