"""Area that each cutter cuts over its radius, and how models differ from Warren and Sinor's plane; a column for each drag bit."""

from figures import style
from figures.compare_models import legend, look

BITS = {"bit-a": "Bit A", "bit-b": "Bit B", "bit-c": "Bit C"}
PLANE = "warren-sinor"
SMALL = 1e-6  # m2: below it a difference in percent says nothing


def draw_areas(axes, result):
    for model in (PLANE, "tdbd"):
        areas = result.parts(model, "area").values()
        axes.plot([1e3 * r for r, _ in areas], [1e6 * a for _, a in areas], linestyle="none", label=result.titles.get(model), **look(model))


def draw_differences(axes, result):
    plane = result.parts(PLANE, "area")
    for model, title in result.titles.items():
        areas = {p: v for p, v in result.parts(model, "area").items() if model != PLANE and p in plane and plane[p][1] > SMALL}
        if areas:
            axes.plot([1e3 * r for r, _ in areas.values()], [100.0 * (a / plane[p][1] - 1.0) for p, (_, a) in areas.items()],
                      linestyle="none", label=title, **look(model))
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    axes.set(xlabel="radius of the tip (mm)", ylim=(-15.0, 15.0))


def draw(results):
    bits = {group: results[group] for group in BITS if group in results}
    figure, panels = style.panels(2, max(1, len(bits)), (10.2, 6.2), sharex=True, sharey="row", squeeze=False)
    for (upper, lower), (group, runs) in zip(panels.T, bits.items()):
        _, result = runs[-1]
        draw_areas(upper, result)
        draw_differences(lower, result)
        upper.set_title(f"{BITS[group]}, {1e3 * result.advance:.3g} mm/rev")
    panels[0, 0].set_ylim(bottom=0.0)
    panels[0, 0].set_ylabel("area cut (mm²)")
    panels[1, 0].set_ylabel("difference from Warren and Sinor (%)")
    legend(panels[0, -1], "Areas")
    legend(panels[1, -1], "Areas")
    return figure
