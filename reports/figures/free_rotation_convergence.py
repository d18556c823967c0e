"""Figure 5.3: convergence in free rotation for the variations of table 5.2."""

from figures import results, style

BODIES = {"symmetric": "symmetric body", "asymmetric": "asymmetric body"}
CONES = {"still": "cones still", "spinning": "equal spins", "unequal": "unequal cones and spins"}
METHODS = {"lie-midpoint": ("thesis", (0, (4, 2)), "^"), "split": ("split", "solid", "o")}
VARIABLES = {"attitude": style.BLUE, "body_momentum": style.RED, "cone_angle": style.GREEN,
             "cone_momentum": style.PURPLE}


def draw_variables(axes, run, name, dash, marker):
    study = results.convergence(run)
    for variable, colour in VARIABLES.items():
        if variable not in study:
            continue
        v = study[variable]
        text = f"{name}, {variable.replace('_', ' ')}: {v.words}"
        if v.positive():
            axes.loglog(*v.positive(), color=colour, linestyle=dash, marker=marker, label=text)
        else:
            axes.plot([], [], color=colour, linestyle=dash, marker=marker, label=text)


def draw_panel(axes, inputs, body, cones):
    for settings, run in inputs.sweep(f"free-{body}-{cones}"):
        draw_variables(axes, run, *METHODS[settings["integrator.drift"]])
    axes.set_title(f"{BODIES[body]}, {CONES[cones]}")
    axes.legend(fontsize=5.8, loc="lower right", handlelength=3.0)


def draw(inputs):
    figure, grid = style.panels(2, 3, (11.0, 7.4), sharex=True, sharey=True)
    for row, body in zip(grid, BODIES):
        for axes, cones in zip(row, CONES):
            draw_panel(axes, inputs, body, cones)
        row[0].set_ylabel("error at the end (rad, N m s)")
    for axes in grid[-1]:
        axes.set_xlabel("step (s)")
    return figure
