"""Ours: how much one step of each drift changes the symplectic form."""

import numpy as np

from figures import style

ROUNDING = np.finfo(float).eps


def draw_case(axes, rows, case):
    for drift, (label, colour, marker) in style.DRIFTS.items():
        own = sorted((r for r in rows if r["case"] == case and r["drift"] == drift), key=lambda r: r["h"])
        steps = [r["h"] for r in own]
        axes.loglog(steps, [max(r["defect"], ROUNDING / 10) for r in own], marker, color=colour, label=label)
        closed = [(r["h"], r["closed_form"]) for r in own if r.get("closed_form")]
        if closed:
            axes.loglog(*zip(*closed), color=colour, linewidth=0.9, label="its closed form")
    axes.axhline(ROUNDING, color=style.GREY, linewidth=0.8, linestyle=":")
    axes.annotate("machine epsilon", (1.0, ROUNDING), xycoords=("axes fraction", "data"), ha="right",
                  va="bottom", fontsize=7, color=style.GREY)
    axes.set_title(case.replace("_", " ").replace("-", " "))


def draw(inputs):
    rows = inputs.table("symplectic-defect")
    cases = list(dict.fromkeys(r["case"] for r in rows or [])) or [None]
    columns = min(3, len(cases))
    lines = -(-len(cases) // columns)
    figure, grid = style.panels(lines, columns, (3.4 * columns + 0.6, 3.1 * lines + 0.4), squeeze=False, sharex=True,
                                sharey=True)
    for axes, case in zip(grid.flat, cases):
        draw_case(axes, rows, case) if case else style.say_missing(axes, "the symplectic defect")
    for axes in grid.flat[len(cases):]:
        axes.set_visible(False)
    for axes in grid[:, 0]:
        axes.set_ylabel(r"$\|J^T\Omega J-\Omega\|_F$ of one step")
    for axes in grid[-1]:
        axes.set_xlabel("step (s)")
    if rows:
        grid[0, 0].legend(fontsize=7)
    return figure
