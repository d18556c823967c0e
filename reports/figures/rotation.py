"""Chapter 5, the rotating bit: figures 5.2 to 5.5, tables 5.1 and 5.2, and figures of TDBD on energy, symplecticity and cost."""

import tomllib
from pathlib import Path

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import NullFormatter

from figures import results, style

def lines(axes, time, values, colours, label):
    for i, colour in enumerate(colours):
        axes.plot(time, values[:, i], color=colour, label=label.format("xyz"[i], i + 1))
    axes.legend(ncol=3, loc="best")


def applied_torque(inputs):
    """Figure 5.2: what an applied torque does to a body with three spinning cones."""
    time, w_B, spin = results.history(inputs.folder("applied-torque"), "time", "angular_velocity",
                                      "cone_spin")
    figure, (body, cones) = style.panels(2, 1, (7.0, 5.2), sharex=True)
    lines(body, time, w_B, style.XYZ.values(), "$W_{0}$")
    lines(cones, time, spin, style.CONES[:spin.shape[1]], "cone {1}")
    body.set_ylabel("angular velocity, body frame (rad/s)")
    cones.set(ylabel="spin of the cones (rad/s)", xlabel="time (s)", xlim=(time[0], time[-1]))
    return figure


HEADS_OF_FREE_ROTATION_CASES = ("case", "principal inertias kg m2", "first rotation vector rad", "angular velocity rad/s", "axial inertias of the cones kg m2", "spins of the cones rad/s")


def listed(numbers):
    return ", ".join(f"{n:g}" for n in numbers)


def row(path, text):
    case = tomllib.loads(text)
    body, cones = case["body"], case["cones"]
    inertia = body["inertia"]
    if any(inertia[i][j] for i in range(3) for j in range(3) if i != j):
        raise ValueError(f"{path}: the table expects an inertia in principal axes")
    return [Path(path).stem.replace("-", " body, cones "), listed(inertia[i][i] for i in range(3)), listed(body["rotation_vector"]),
            listed(body["angular_velocity"]), listed(c["axial_inertia"] for c in cones), listed(c["spin"] for c in cones)]


def free_rotation_cases(inputs):
    """Table 5.2: how the cases of the convergence of free rotation vary."""
    order = [f"{body}-{cones}" for body in ("symmetric", "asymmetric") for cones in ("still", "spinning", "unequal")]
    texts = {Path(path).stem: (path, text) for path, text in inputs.texts().items()}
    return {"heads": HEADS_OF_FREE_ROTATION_CASES, "rows": [row(*texts[name]) for name in sorted(texts, key=order.index)]}


BODIES = {"symmetric": "symmetric body", "asymmetric": "asymmetric body"}
CONES = {"still": "cones still", "spinning": "equal cones and spins", "unequal": "unequal cones and spins"}
METHODS = {"lie-midpoint": ("thesis drift, reconstructed", (0, (4, 2)), "^"), "split": ("split drift", "solid", "o")}
VARIABLES = {"attitude": style.BLUE, "body_momentum": style.RED, "angular_velocity": style.GREEN,
             "cone_angles": style.GOLD, "space_momentum": style.PURPLE, "cone_momenta": style.BLACK}
ROUNDING_OF_FREE_ROTATION_CONVERGENCE = 1e-12  # smaller differences are no errors of the method


def draw_errors(axes, study, colour, dash, marker):
    seen = study.errors > ROUNDING_OF_FREE_ROTATION_CONVERGENCE
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


def free_rotation_convergence(inputs):
    """Figure 5.3: convergence in free rotation for the variations of table 5.2."""
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


TRACES_OF_SLOW_TOP_ENERGY = {"slow-top-thesis": ("thesis drift, reconstructed", style.RED, (0, (4, 2))),
          "slow-top-split": ("split drift", style.BLUE, "solid")}


def draw_energies(energy, error, run, label, colour, dash):
    time, kinetic, total = results.history(run, "time", "kinetic_energy", "total_energy")
    energy.plot(time, kinetic, color=colour, linestyle=dash, label=label)
    error.plot(time, 100.0 * (total - total[0]) / abs(total[0]), color=colour, linestyle=dash, label=label)


def draw_momenta(axes, run, dash):
    time, momentum = results.history(run, "time", "space_momentum")
    for i, (name, colour) in enumerate(style.XYZ.items()):
        axes.plot(time, momentum[:, i], color=colour, linestyle=dash,
                  label=f"$\\pi_{name}$" if dash == "solid" else None)


def vertical_change(run):
    """In words: the vertical momentum keeps every bit, which no line can show."""
    [momentum] = results.history(run, "space_momentum")
    change = abs(momentum[:, 2] - momentum[0, 2]).max()
    return f"{change:.1e} N m s" if change else "exactly 0"


def slow_top_energy(inputs):
    """Figure 5.4: kinetic energy and angular momenta of the slow top, and what should not change."""
    figure, (energy, momenta, error) = style.panels(3, 1, (7.0, 7.6), sharex=True)
    changes = []
    for group, (label, colour, dash) in TRACES_OF_SLOW_TOP_ENERGY.items():
        run = inputs.folder(group)
        draw_energies(energy, error, run, label, colour, dash)
        draw_momenta(momenta, run, dash)
        changes.append(f"{label}: {vertical_change(run)}")
    energy.set_ylabel("kinetic energy (J)")
    momenta.set(ylabel="angular momentum\nin space (N m s)", title="largest change of $\\pi_z$: " + "; ".join(changes))
    error.set(ylabel="change of the total energy (%)", xlabel="time (s)")
    for axes, place in ((energy, "upper center"), (momenta, "lower left"), (error, "lower center")):
        axes.legend(loc=place)
        axes.margins(x=0.0)
    return figure


TRACES_OF_SLOW_TOP_AXIS = {"slow-top-thesis": ("thesis drift, reconstructed", style.RED, (0, (4, 2))),
          "slow-top-split": ("split drift", style.BLUE, "solid")}


def draw_path(axes, run, label, colour, dash):
    [axis] = results.history(run, "axis_W")
    axes.plot(axis[:, 0], axis[:, 1], color=colour, linestyle=dash, linewidth=1.1, label=label)


def draw_distance(axes, run, reference, label, colour, dash):
    """Between the axes at the same time; the reference has a row for each of the run's."""
    time, axis = results.history(run, "time", "axis_W")
    exact_time, exact = results.history(reference, "time", "axis_W")
    row = np.searchsorted(exact_time, time - 1e-9)
    assert np.allclose(exact_time[row], time), "the reference has other times"
    distance = np.linalg.norm(axis - exact[row], axis=1)
    axes.semilogy(time[1:], distance[1:], color=colour, linestyle=dash, label=label)


def slow_top_axis(inputs):
    """Figure 5.5: the path of the slow top's axis, seen along the vertical; and its error."""
    figure, (path, distance) = style.panels(1, 2, (9.4, 4.4))
    reference = inputs.folder("slow-top-reference")
    [exact] = results.history(reference, "axis_W")
    path.plot(exact[:, 0], exact[:, 1], color=style.GREY, linewidth=4, alpha=0.4, label="reference, order 8")
    for group, trace in TRACES_OF_SLOW_TOP_AXIS.items():
        draw_path(path, inputs.folder(group), *trace)
        draw_distance(distance, inputs.folder(group), reference, *trace)
    path.plot(*exact[0, :2], "o", color=style.BLACK)
    step = results.summary(inputs.folder("slow-top-split"))["step_s"]
    path.set(aspect="equal", xlim=(-1.02, 1.02), ylim=(-1.02, 1.02), xlabel="$(R\\,e_3)_x$", ylabel="$(R\\,e_3)_y$",
             title=f"path of the axis, h = {step:g} s")
    path.legend(loc="lower right", fontsize=7)
    distance.set(xlabel="time (s)", ylabel="distance of $R\\,e_3$ from the reference", title="error of the axis")
    distance.legend(loc="lower right")
    return figure


ROUNDING_OF_SYMPLECTIC_DEFECT = np.finfo(float).eps
FAR_ABOVE = 1e-9  # a defect larger than this is the method's, not rounding's


def order_in_words(rows):
    """Slope of the thesis drift's defects over the shortest steps at which they are above rounding."""
    seen = [(r["h"], r["defect"]) for r in rows if r["drift"] == "lie-midpoint" and r["defect"] > FAR_ABOVE][:4]
    if len(seen) < 2:
        return ""
    return f": order {np.polyfit(*np.log(np.array(seen).T), 1)[0]:.2f}"


def draw_defect(axes, own, drift):
    label, colour, marker = style.DRIFTS[drift]
    steps = [r["h"] for r in own]
    axes.loglog(steps, [max(r["defect"], ROUNDING_OF_SYMPLECTIC_DEFECT / 10) for r in own], marker, color=colour, label=label)
    closed = [(r["h"], r["closed_form"]) for r in own if (r.get("closed_form") or 0.0) > ROUNDING_OF_SYMPLECTIC_DEFECT]
    if closed:
        axes.loglog(*zip(*closed), color=colour, linewidth=0.9, label="its closed form")


def draw_case(axes, rows, case):
    own = sorted((r for r in rows if r["case"] == case), key=lambda r: r["h"])
    for drift in style.DRIFTS:
        draw_defect(axes, [r for r in own if r["drift"] == drift], drift)
    axes.axhline(ROUNDING_OF_SYMPLECTIC_DEFECT, color=style.GREY, linewidth=0.8, linestyle=":", label="machine epsilon")
    steps = sorted({r["h"] for r in own})
    axes.set_xticks(steps, [f"{h:.2g}" for h in steps], rotation=45 if len(steps) > 5 else 0)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_title(case.replace("_", " ") + order_in_words(own))


def symplectic_defect(inputs):
    """Addition of TDBD: how much one step of each drift changes the symplectic form."""
    rows = inputs.table("symplectic-defect")
    if unknown := {r["drift"] for r in rows or []} - set(style.DRIFTS):
        raise ValueError(f"the table symplectic-defect has drifts without a colour: {sorted(unknown)}")
    cases = list(dict.fromkeys(r["case"] for r in rows or [])) or [None]
    columns = min(3, len(cases))
    lines = -(-len(cases) // columns)
    figure, grid = style.panels(lines, columns, (3.4 * columns + 0.6, 2.9 * lines + 0.4), squeeze=False,
                                sharex=True, sharey=True)
    for axes, case in zip(grid.flat, cases):
        draw_case(axes, rows, case) if case else style.say_missing(axes, "the symplectic defect")
    for axes in grid.flat[len(cases):]:
        axes.set_visible(False)
    for axes in grid[:, 0]:
        axes.set_ylabel(r"$\|J^T\Omega J-\Omega\|_F$ of one step")
    for axes in grid[-1]:
        axes.set_xlabel("step (s)")
    grid[0, 0].set_ylim(bottom=ROUNDING_OF_SYMPLECTIC_DEFECT / 20)
    if rows:
        grid[0, 0].legend(fontsize=6.5, loc="center right", bbox_to_anchor=(1.0, 0.38), labelspacing=0.3)
    return figure


SLOTS = 200
PERCENT = 100.0


def relative_change(run):
    """Time (s), and change of the total energy in per cent of its first value's size."""
    time, total = results.history(run, "time", "total_energy")
    return time, PERCENT * (total - total[0]) / abs(total[0])


def draw_change(axes, run, drift):
    """Mean and range in intervals of time: lines through all rows would hide each other."""
    label, colour, _ = style.DRIFTS[drift]
    time, change = relative_change(run)
    slots = np.array_split(np.arange(len(time)), min(SLOTS, len(time)))
    middle = [time[s].mean() for s in slots]
    axes.fill_between(middle, [change[s].min() for s in slots], [change[s].max() for s in slots],
                      color=colour, alpha=0.2, linewidth=0)
    axes.plot(middle, [change[s].mean() for s in slots], color=colour,
              label=f"{label}: {change[slots[-1]].mean():+.2g} %")


def energy(inputs):
    """Addition of TDBD: the energy of a heavy body with spinning cones over more than a million steps."""
    figure, (all_drifts, without) = style.panels(2, 1, (7.4, 6.4), sharex=True)
    for settings, run in inputs.sweep("energy"):
        drift = settings["integrator.drift"]
        draw_change(all_drifts, run, drift)
        if drift != "lie-midpoint":
            draw_change(without, run, drift)
    all_drifts.set(ylabel="change of the energy (%)", title="all drifts, with their final change")
    without.set(ylabel="change of the energy (%)", xlabel="time (s)",
                title="without the Lie midpoint, enlarged: mean and range")
    all_drifts.margins(x=0.0)
    without.margins(x=0.0, y=0.2)
    all_drifts.legend(loc="upper left")
    without.legend(loc="upper center", ncol=3)
    return figure


ORDERS = (2, 4, 6, 8)
NAMES = {2: "order 2", 4: "order 4, Suzuki", 6: "order 6, Kahan-Li", 8: "order 8, Kahan-Li"}
GROUPS = ("work-precision", "work-precision-coarse")
RIVALS = {"rk8pd": ("Runge-Kutta 8(9), GSL", "solid"), "rkf45": ("Runge-Kutta 4(5), GSL", (0, (4, 2))),
          "rk4": ("classical Runge-Kutta", ":")}


def points(runs, reference):
    """(torque evaluations, attitude error) of runs, by falling work."""
    found = [(results.summary(run)["torque_evaluations"], results.attitude_error(run, reference)) for run in runs]
    return zip(*sorted(found))


def draw_work(axes, inputs, reference, order, drift):
    label, colour, marker = style.DRIFTS[drift]
    runs = [run for group in GROUPS for settings, run in inputs.sweep(group)
            if (settings["integrator.drift"], settings["integrator.order"]) == (drift, order)]
    axes.loglog(*points(runs, reference), color=colour, marker=marker, markersize=3, label=label)


SLOPE_FROM = 3e-3  # rad: errors at which the lines of the slopes begin


def draw_slope(axes, order):
    """The slope of the nominal order, left of the lines of the methods, over a factor of four in work."""
    drawn = [line.get_xydata() for line in axes.get_lines()]
    near = [work for line in drawn for work, error in line if error < SLOPE_FROM]
    if not near:
        return
    work = 0.55 * min(near) * np.array([1.0, 2.5])
    axes.loglog(work, SLOPE_FROM * (work / work[0]) ** -order, color=style.BLACK, linewidth=1.2, linestyle=(0, (1, 1)))
    axes.annotate(f"slope -{order}", (work[0], SLOPE_FROM), xytext=(-3, 3), textcoords="offset points", ha="right", va="bottom", fontsize=7)


def draw_rivals(axes, inputs):
    for method, (label, dash) in RIVALS.items():
        for _, run in inputs.sweep(f"rival-{method}"):
            found = [(line["torque_evaluations"], line["attitude_error_rad"]) for line in results.printed_lines(run)]
            axes.loglog(*zip(*sorted(found)), color=style.GREY, linestyle=dash, linewidth=1.0, label=label)


def work_precision(inputs):
    """Addition of TDBD: error against torque evaluations, for every drift and order, beside GSL's Runge-Kutta."""
    figure, grid = style.panels(2, 2, (9.0, 7.4), sharex=True, sharey=True)
    reference = inputs.folder("slow-top-reference")
    for axes, order in zip(grid.flat, ORDERS):
        for drift in style.DRIFTS:
            draw_work(axes, inputs, reference, order, drift)
        draw_slope(axes, order)
        draw_rivals(axes, inputs)
        axes.set_title(NAMES[order])
    for axes in grid[:, 0]:
        axes.set_ylabel("attitude error at the end (rad)")
    for axes in grid[-1]:
        axes.set_xlabel("torque evaluations")
    grid[0, 0].set_ylim(1e-13, 10.0)
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="upper center", ncol=4)
    figure.suptitle(" \n ")  # room for the legend
    return figure


HEADS_OF_VIRTUAL_POWER_TABLE = ("virtual velocity", "acceleration of", "their product over the mass", "largest difference, relative", "in the last draw: summed", "closed form")


def virtual_power_table(inputs):
    """Table 5.1: the nine products of virtual and actual kinematic quantities, each checked by numbers."""
    rows = inputs.table("virtual-power")
    if rows is None:
        return {"heads": ["not measured in this run"], "rows": []}
    return {"heads": HEADS_OF_VIRTUAL_POWER_TABLE, "rows": [[r["virtual"], r["actual"], r["form"], f"{r['worst']:.1e}", f"{r['sum']:.6g}" if r["form"] != "0" else f"{r['sum']:.0e}",
                                      f"{r['closed']:.6g}"] for r in rows]}
