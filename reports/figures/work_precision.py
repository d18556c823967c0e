"""Ours: error against torque evaluations, for every drift and order, beside GSL's Runge-Kutta."""

from figures import results, style

ORDERS = (2, 4, 6, 8)
NAMES = {2: "order 2", 4: "order 4, Suzuki", 6: "order 6, Kahan-Li", 8: "order 8, Kahan-Li"}
GROUPS = ("work-precision", "work-precision-coarse")
RIVALS = {"rk8pd": ("Runge-Kutta 8(9), GSL", "solid"), "rkf45": ("Runge-Kutta 4(5), GSL", (0, (4, 2))),
          "rk4": ("classical Runge-Kutta", ":")}


def points(runs, reference):
    """(torque evaluations, attitude error) of runs, by falling work."""
    found = [(results.summary(run)["torque_evaluations"], results.attitude_error(run, reference)) for run in runs]
    return zip(*sorted(found))


def draw_drift(axes, inputs, reference, order, drift):
    label, colour, marker = style.DRIFTS[drift]
    runs = [run for group in GROUPS for settings, run in inputs.sweep(group)
            if (settings["integrator.drift"], settings["integrator.order"]) == (drift, order)]
    axes.loglog(*points(runs, reference), color=colour, marker=marker, markersize=3, label=label)


def draw_rivals(axes, inputs):
    for method, (label, dash) in RIVALS.items():
        for _, run in inputs.sweep(f"rival-{method}"):
            found = [(line["torque_evaluations"], line["attitude_error_rad"]) for line in results.printed_lines(run)]
            axes.loglog(*zip(*sorted(found)), color=style.GREY, linestyle=dash, linewidth=1.0, label=label)


def draw(inputs):
    figure, grid = style.panels(2, 2, (9.0, 7.4), sharex=True, sharey=True)
    reference = inputs.folder("slow-top-reference")
    for axes, order in zip(grid.flat, ORDERS):
        for drift in style.DRIFTS:
            draw_drift(axes, inputs, reference, order, drift)
        draw_rivals(axes, inputs)
        axes.set_title(NAMES[order])
    for axes in grid[:, 0]:
        axes.set_ylabel("attitude error at the end (rad)")
    for axes in grid[-1]:
        axes.set_xlabel("torque evaluations")
    grid[0, 0].set_ylim(1e-13, 10.0)
    grid[0, 0].legend(loc="lower left", fontsize=7)
    return figure
