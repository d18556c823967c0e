"""Work-precision diagrams: errors over torque evaluations, of convergence studies or of single rotations."""

import math

import numpy as np

from figures import results, style, traces

COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD, style.SKY, style.BLACK, style.GREY)
MARKERS = "os^Dv<>P"
ATTITUDE = "attitude"  # the variable of a convergence study that is drawn, where it has this one
ROUNDING = 1e-14  # relative errors below are rounding


class Group:
    """One line: (torque evaluations, error) of runs that differ only in their steps, and the nominal order."""

    def __init__(self, label, order, points):
        kept = sorted((w, e) for w, e in points if w > 0 and e > 0.0 and math.isfinite(e))
        self.label, self.order = label, order
        self.work, self.errors = (np.array(v, dtype=float) for v in (zip(*kept) if kept else ((), ())))


def evaluations(study):
    """Of the levels; empty if the study has none, as that of a bit that drills."""
    found = [level.get("torque_evaluations") for level in study["levels"]]
    return [] if None in found else found


def group_of_study(folder):
    """A convergence study of a rotation. Raises ValueError."""
    study = results.read_json(folder, "convergence.json")
    work = evaluations(study)
    if not work:
        raise ValueError(f"{folder}: found levels without torque_evaluations, expected a convergence study of a rotation (tdbd rotate) "
                         "by this version of TDBD")
    name = ATTITUDE if ATTITUDE in study["variables"] else next(iter(study["variables"]))
    variable = study["variables"][name]
    errors = np.array(variable["errors" if study["against"] == "reference" else "differences"], dtype=float) / (variable["scale"] or 1.0)
    return Group(f"{folder.name}: {name}, order {results.in_words(variable)}", study["nominal_order"], zip(work, errors))


def groups_of_runs(folders):
    """Rotations by integrator and order; errors of the attitude relative to the run with the most evaluations of the highest order."""
    summaries = {folder: results.summary(folder) for folder in folders}
    if len({s.get("duration_s") for s in summaries.values()}) > 1:
        ends = ", ".join(f"{s.get('duration_s'):g} s" for s in summaries.values())
        raise ValueError(f"found rotations that end at different times ({ends}), expected the same duration")
    best = max(folders, key=lambda f: (summaries[f]["integrator"]["order"], summaries[f]["torque_evaluations"]))
    lines = {}
    for folder, s in summaries.items():
        if folder != best:
            key = (s["integrator"]["drift"], s["integrator"]["order"])
            lines.setdefault(key, []).append((s["torque_evaluations"], results.attitude_error(folder, best)))
    return [Group(f"{drift}, order {order}", order, points) for (drift, order), points in sorted(lines.items())], best


def draw_slope(axes, group, orders_drawn):
    """The nominal order of a group as a dashed line below its points."""
    seen = group.errors > ROUNDING
    if not group.order or not seen.any() or group.order in orders_drawn:
        return
    k = np.flatnonzero(seen)[-1]
    work = np.array([group.work[seen].min(), group.work[seen].max()])
    if work[0] == work[1]:
        work = work * np.array([0.5, 2.0])
    axes.loglog(work, 0.4 * group.errors[k] * (work / group.work[k]) ** -group.order, color=style.GREY, linestyle="dashed",
                linewidth=1.0, label=f"slope of order {group.order:g}", zorder=1)
    orders_drawn.add(group.order)


def figure_of(groups, title, ylabel):
    figure, axes = style.panels(1, 1, (8.4, 4.8))
    drawn = set()
    for i, group in enumerate(groups):
        if group.work.size:
            axes.loglog(group.work, group.errors, color=COLOURS[i % len(COLOURS)], marker=MARKERS[i % len(MARKERS)], label=group.label)
            draw_slope(axes, group, drawn)
    axes.set(xlabel="torque evaluations", ylabel=ylabel)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=7)
    figure.suptitle(traces.fitted(title, figure), fontsize=10)
    return figure


def of_studies(folders):
    """One line for each convergence study of a rotation. Raises ValueError."""
    studies = [results.read_json(f, "convergence.json") for f in folders]
    title = studies[0]["title"] if len({s["title"] for s in studies}) == 1 else "convergence studies"
    kind = "error to the reference" if studies[0]["against"] == "reference" else "difference to the next level"
    return figure_of([group_of_study(f) for f in folders], f"Work and precision: {title}", f"{kind}, over the variable's size")


def of_runs(folders):
    """Rotations of one case with different steps and integrators. Raises ValueError."""
    groups, best = groups_of_runs(folders)
    return figure_of(groups, f"Work and precision: {results.summary(best)['title']}\nerrors relative to {best.name}",
                     "error of the attitude at the end (rad)")
