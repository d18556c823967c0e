"""Figures 4.16, 4.19, 4.21 and 4.22: a small sheet of rock from above, before and after an operation."""

import numpy as np

from figures import style


def corners(row):
    points, triangles = np.array(row["positions"]), np.array(row["triangles"])
    return points, triangles


def draw_sheet(axes, row):
    points, triangles = corners(row)
    axes.triplot(points[:, 0], points[:, 1], triangles, color="0.55", linewidth=0.8)
    if "edge" in row:
        axes.plot(*np.array(row["edge"])[:, :2].T, "o-", color=style.RED, linewidth=2.4, markersize=4)
    axes.set(aspect="equal", title=row["stage"])
    axes.set_axis_off()


def draw(inputs):
    [(name, table)] = inputs.tables.items()
    if table is None:
        return style.only_words(name)
    figure, frames = style.panels(1, len(table), (3.4 * len(table), 3.6))
    for axes, row in zip(frames, table):
        draw_sheet(axes, row)
        axes.set_title(f"{row['stage']}: {len(row['triangles'])} triangles")
    before = {tuple(p) for p in table[0]["positions"]}
    for axes, row in zip(frames[1:], table[1:]):
        new = np.array([p for p in row["positions"] if tuple(p) not in before])
        if len(new):
            axes.plot(new[:, 0], new[:, 1], "o", color=style.BLUE, markersize=4)
    return figure
