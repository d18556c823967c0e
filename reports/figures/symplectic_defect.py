"""Ours: how much one step of each drift changes the symplectic form."""

import numpy as np
from matplotlib.ticker import NullFormatter

from figures import style

ROUNDING = np.finfo(float).eps
FAR_ABOVE = 1e-9  # a defect larger than this is the method's, not rounding's


def order_in_words(rows):
    """Slope of the thesis drift's defects over the shortest steps at which they stand above rounding."""
    seen = [(r["h"], r["defect"]) for r in rows if r["drift"] == "lie-midpoint" and r["defect"] > FAR_ABOVE][:4]
    if len(seen) < 2:
        return ""
    return f": order {np.polyfit(*np.log(np.array(seen).T), 1)[0]:.2f}"


def draw_drift(axes, own, drift):
    label, colour, marker = style.DRIFTS[drift]
    steps = [r["h"] for r in own]
    axes.loglog(steps, [max(r["defect"], ROUNDING / 10) for r in own], marker, color=colour, label=label)
    closed = [(r["h"], r["closed_form"]) for r in own if (r.get("closed_form") or 0.0) > ROUNDING]
    if closed:
        axes.loglog(*zip(*closed), color=colour, linewidth=0.9, label="its closed form")


def draw_case(axes, rows, case):
    own = sorted((r for r in rows if r["case"] == case), key=lambda r: r["h"])
    for drift in style.DRIFTS:
        draw_drift(axes, [r for r in own if r["drift"] == drift], drift)
    axes.axhline(ROUNDING, color=style.GREY, linewidth=0.8, linestyle=":", label="machine epsilon")
    steps = sorted({r["h"] for r in own})
    axes.set_xticks(steps, [f"{h:.2g}" for h in steps], rotation=45 if len(steps) > 5 else 0)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_title(case.replace("_", " ") + order_in_words(own))


def draw(inputs):
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
    grid[0, 0].set_ylim(bottom=ROUNDING / 20)
    if rows:
        grid[0, 0].legend(fontsize=6.5, loc="center right", bbox_to_anchor=(1.0, 0.38), labelspacing=0.3)
    return figure
