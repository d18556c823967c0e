"""Waves of a whirling bit's bottom round a circle, on planes and on our mesh."""

from figures import style

ORBITS = {"whirl-1500": "Orbit of 1.5 mm", "whirl-3000": "Orbit of 3 mm"}
LOBES = {"whirl-1500": 73, "whirl-3000": 37}


def series(results, group):
    """[(label, colour, amplitudes)]."""
    _, main = results[group][0]
    yield "72 planes", style.RED, main.harmonics("behr")
    for settings, result in results.get(f"{group}-planes", []):
        planes = settings["compare.planes.planes"]
        yield f"{planes} planes", style.GOLD if planes < 500 else style.GREEN, result.harmonics("behr")
    yield "our mesh", style.BLUE, main.harmonics("tdbd")


def draw(results):
    groups = [g for g in ORBITS if g in results]
    figure, panels = style.panels(4, max(1, len(groups)), (10.2, 7.6), sharex=True, sharey="col", squeeze=False)
    for column, group in enumerate(groups):
        for axes, (label, colour, waves) in zip(panels[:, column], series(results, group)):
            if waves is None:
                style.say_missing(axes, label)
                continue
            axes.vlines(range(1, len(waves)), 0.0, 1e3 * waves[1:], color=colour, linewidth=1.0)
            axes.axvline(LOBES[group], color=style.GREY, linestyle=":", linewidth=0.8, zorder=0)
            axes.set_title(f"{ORBITS[group]}: {label}")
            axes.set(xlim=(0.0, 240.0), ylabel="mm")
        panels[-1, column].set_xlabel("waves round the circle")
    return figure
