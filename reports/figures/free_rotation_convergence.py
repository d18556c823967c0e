"""Figure 5.3: convergence in free rotation for the variations of table 5.2."""

from matplotlib.lines import Line2D

from figures import results, style

BODIES = {"symmetric": "symmetric body", "asymmetric": "asymmetric body"}
CONES = {"still": "cones still", "spinning": "equal cones and spins", "unequal": "unequal cones and spins"}
METHODS = {"lie-midpoint": ("thesis drift, reconstructed", (0, (4, 2)), "^"), "split": ("split drift", "solid", "o")}
VARIABLES = {"attitude": style.BLUE, "body_momentum": style.RED, "angular_velocity": style.GREEN,
             "cone_angles": style.GOLD, "space_momentum": style.PURPLE, "cone_momenta": style.BLACK}
ROUNDING = 1e-12  # smaller differences are no errors of the method


def draw_errors(axes, study, colour, dash, marker):
    seen = study.errors > ROUNDING
    axes.loglog(study.sizes[seen], study.errors[seen], color=colour, linestyle=dash, marker=marker, markersize=3)


def draw_panel(axes, inputs, body, cones):
    """The legend of a panel is its table of observed orders: thesis drift, split drift."""
    words = {variable: [] for variable in VARIABLES}
    for settings, run in inputs.sweep(f"free-{body}-{cones}"):
        studies = results.convergence(run)
        for variable, colour in VARIABLES.items():
            draw_errors(axes, studies[variable], colour, *METHODS[settings["integrator.drift"]][1:])
            words[variable].append(studies[variable].words)
    labels = [f"{v.replace('_', ' ')}: {', '.join(w)}" for v, w in words.items()]
    axes.legend([Line2D([], [], color=c) for c in VARIABLES.values()], labels, fontsize=7, loc="lower right",
                title="observed orders", title_fontsize=7, handlelength=1.2, labelspacing=0.25)
    axes.set_title(f"{BODIES[body]}, {CONES[cones]}")


def draw(inputs):
    figure, grid = style.panels(2, 3, (11.0, 7.2), sharex=True, sharey=True)
    for row, body in zip(grid, BODIES):
        for axes, cones in zip(row, CONES):
            draw_panel(axes, inputs, body, cones)
        row[0].set_ylabel("difference to half the step (rad, N m s, rad/s)")
    for axes in grid[-1]:
        axes.set_xlabel("step (s)")
    grid[0, 0].set_ylim(bottom=1e-12)
    figure.legend([Line2D([], [], color=style.BLACK, linestyle=d, marker=m) for _, d, m in METHODS.values()],
                  [f"{label} (order given {place})" for (label, _, _), place in
                   zip(METHODS.values(), ("first", "second"))], loc="upper center", ncol=2)
    figure.suptitle(" ")  # room for the legend
    return figure
