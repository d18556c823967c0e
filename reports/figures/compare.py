"""The models of chapter 2 beside one another: areas, speeds of cones, noise, rates, the bottom in whirl, wear."""

from figures import style

# How the models of chapter 2 look in the figures that compare them.

# model: (colour, marker)
LOOKS = {
    "tdbd": (style.BLACK, "o"),
    "warren-sinor": (style.GREY, "x"),
    "behr": (style.RED, "^"),
    "glowka": (style.PURPLE, "D"),
    "langeveld": (style.BLUE, "v"),
    "hanson-hansen": (style.GREEN, "s"),
    "briggs": (style.RED, "^"),
    "winters": (style.GOLD, "P"),
    "ma-azar": (style.GREY, "1"),
    "ma-zhou-deng": (style.BLUE, "v"),
    "huang-cawthorne-1": (style.PURPLE, "D"),
    "huang-cawthorne-2": (style.SKY, "<"),
    "sheppard-lesage": (style.GREY, "x"),
}
OTHER = (style.SKY, "*")


def look(model):
    """Keywords of plot() for a model's points."""
    colour, marker = LOOKS.get(model, OTHER)
    return {"color": colour, "marker": marker, "markersize": 6 if model == "tdbd" else 4, "fillstyle": "none"}


def title(results, model):
    """A model's name for readers, from the first run that has it."""
    for runs in results.values():
        for _, result in runs:
            if model in result.titles:
                return result.titles[model]
    return model


def legend(axes, what):
    """A legend; where nothing was drawn, a word instead."""
    if axes.get_legend_handles_labels()[1]:
        axes.legend()
    else:
        style.say_missing(axes, what)


BITS = {"bit-a": "Bit A", "bit-b": "Bit B", "bit-c": "Bit C"}
PLANE = "warren-sinor"
SMALL = 1e-6  # m2: a relative difference has no meaning below it


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


def compare_areas(results):
    """Area that each cutter cuts over its radius, and how models differ from Warren and Sinor's plane; a column for each drag bit."""
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


def compare_cones(results):
    """Mean speed of the cones over the bit's, by model, over the advance."""
    runs = results.get("bit-r", [])
    figure, axes = style.panels(1, 1, (7.2, 4.2))
    for model in dict.fromkeys(m for _, r in runs for m in r.titles):
        shown = [(1e3 * r.advance, r.value(model, "cone_speed_ratio")) for _, r in runs if r.value(model, "cone_speed_ratio") is not None]
        if shown:
            axes.plot(*zip(*shown), "-", linewidth=0.8, label=title(results, model), **look(model))
    axes.set(xlabel="advance (mm a revolution)", ylabel="speed of the cones over the bit's", xlim=(0.0, None))
    legend(axes, "Cones")
    return figure


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


def noise_over_cost(runs, model, quantity):
    """[(cost, noise, what was refined)]."""
    found = [(r.cost(model), r.value(model, quantity), list(settings.values())[-1]) for settings, r in runs if model in r.titles]
    return [p for p in found if p[0] and p[1] is not None and p[1] > LEAST]


def compare_noise(results):
    """Noise of one step's torque over the CPU time of a simulated second."""
    figure, axes = style.panels(1, 1, (7.6, 4.8))
    for group, series in SERIES.items():
        for model, quantity, label, colour, marker, line in series:
            shown = noise_over_cost(results.get(group, []), model, quantity)
            if not shown:
                continue
            cost, noise, refined = zip(*shown)
            axes.loglog(cost, [100.0 * n for n in noise], line, color=colour, marker=marker, label=label)
            for x, y, word in (shown[0], shown[-1]):
                axes.annotate(str(word), (x, 100.0 * y), textcoords="offset points", xytext=(4, 4), fontsize=7, color=colour)
    axes.set(xlabel="CPU time over simulated time", ylabel="noise of the torque (%)")
    legend(axes, "Noise")
    return figure


PANELS = {"bit-b": "Bit B (fixed cutters)", "bit-r": "The roller cone bit of the comparison"}


def rates_over_weight(runs, model):
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


def compare_rates(results):
    """Rate of penetration over weight, by model: drag bits and the roller cone bit."""
    groups = [g for g in PANELS if g in results]
    figure, panels = style.panels(1, max(1, len(groups)), (10.2, 4.2), squeeze=False)
    for axes, group in zip(panels[0], groups):
        for model in dict.fromkeys(m for _, r in results[group] for m in r.titles):
            if shown := rates_over_weight(results[group], model):
                weight, rate = zip(*shown)
                axes.plot(weight, rate, "-", linewidth=0.8, label=title(results, model), **look(model))
        axes.set(title=PANELS[group], xlabel="weight (kN)", ylabel="rate of penetration (m/h)", xlim=(0.0, None), ylim=(0.0, None))
        legend(axes, "Rates")
    return figure


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


def compare_spectrum(results):
    """Waves of a whirling bit's bottom round a circle, on planes and on our mesh."""
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


def compare_wear(results):
    """Wear flats over the radius, by model."""
    figure, axes = style.panels(1, 1, (7.2, 4.0))
    runs = results.get("bit-b", [])
    for _, result in runs[len(runs) // 2:][:1]:
        for model, title in result.titles.items():
            if flats := sorted(result.parts(model, "wear_flat").values()):
                axes.plot([1e3 * r for r, _ in flats], [1e6 * a for _, a in flats], linestyle="none", label=title, **look(model))
    axes.set(xlabel="radius of the tip (mm)", ylabel="wear flat (mm²)")
    legend(axes, "Wear")
    return figure
