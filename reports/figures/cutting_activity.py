"""In place of figures 4.2, 4.3, 4.11 and 4.13: our step as activities, with how often runs took each branch."""

from figures import style
from figures.flow import Flow


class Counts:
    """The same count of all runs, in a line for each."""

    def __init__(self, rows):
        self.rows = rows

    def of(self, count):
        return "  |  ".join(f"{count(row):,}".replace(",", " ") for row in self.rows)


def groups(row):
    return row["boxes"] // row["steps"]


def draw_step(flow, n):
    """Figure 4.2."""
    flow.title(0, 0.2, "A step (4.2)")
    flow.action(0, 1, "the bit moves", n.of(lambda r: r["steps"]))
    flow.action(0, 2, "find rock in each group's way", n.of(lambda r: r["boxes"]))
    flow.action(0, 3, "map, move and measure", n.of(lambda r: r["moved"]))
    flow.decision(0, 4, "did anything move?")
    flow.action(0, 5, "sections and contact areas", n.of(lambda r: r["steps"]))
    flow.decision(0, 6, "maintenance due?")
    flow.action(0, 7, "maintain the surface", n.of(lambda r: r["maintenances"]))
    for row in range(1, 7):
        flow.below(0, row, {4: "no", 6: "yes"}.get(row, ""))
    flow.back(0, 4, 3, 1, "yes: " + n.of(lambda r: r["passes"] - r["steps"]))
    flow.back(0, 6, 1, -1, "no: " + n.of(lambda r: r["steps"] - r["maintenances"]))


def draw_find(flow, n):
    """Figure 4.3."""
    flow.title(1, 0.2, "Find (4.3)")
    flow.action(1, 1, "motion box of each group:\nbefore and after the step", n.of(lambda r: r["boxes"]))
    flow.decision(1, 2, "does it reach the rock?")
    flow.action(1, 3, "list of vertices around it", n.of(lambda r: r["listed"]))
    flow.action(1, 4, "planes of the group's hull", n.of(lambda r: r["listed"]))
    flow.decision(1, 5, "does a plane keep it out?")
    flow.action(1, 6, "candidates", n.of(lambda r: r["candidates"]))
    for row in range(1, 6):
        flow.below(1, row, {2: "yes: " + n.of(lambda r: r["reached"]), 5: "no"}.get(row, ""))
    flow.end(1, 6.9, "outside a plane: stays", n.of(lambda r: r["listed"] - r["candidates"]))


def draw_update(flow, n):
    """Figure 4.11."""
    flow.title(2, 0.2, "Update a vertex (4.11)")
    flow.action(2, 1, "candidate", n.of(lambda r: r["tested"]))
    flow.action(2, 2, "map the update direction\nto its azimuth", n.of(lambda r: r["tested"]))
    flow.action(2, 3, "path relative to the part", n.of(lambda r: r["tested"]))
    flow.action(2, 4, "farthest exit along the direction", n.of(lambda r: r["tested"]))
    flow.decision(2, 5, "swept by the part?")
    flow.action(2, 6, "move it (4.13)", n.of(lambda r: r["moved"]))
    for row in range(1, 6):
        flow.below(2, row, "yes" if row == 5 else "")
    flow.end(2, 6.9, "not swept: stays", n.of(lambda r: r["tested"] - r["moved"]))


def draw_move(flow, n):
    """Figure 4.13."""
    flow.title(3, 0.2, "Move a vertex (4.13)")
    flow.action(3, 1, "swept vertex", n.of(lambda r: r["moved"]))
    flow.decision(3, 2, "on the rock's boundary?")
    flow.action(3, 3, "volume of the triangles around it", n.of(lambda r: r["moved"]))
    flow.action(3, 4, "note the part that cut it", n.of(lambda r: r["moved"]))
    flow.action(3, 5, "place it; mark it and its\nneighbours as touched", n.of(lambda r: r["moved"]))
    flow.action(3, 6, "removed in all, cm3", "  |  ".join(f"{1e6 * r['removed_m3']:.2f}" for r in n.rows))
    for row in range(1, 6):
        flow.below(3, row, "no" if row == 2 else "")
    flow.end(3, 6.9, "on the boundary: ends the run")


def draw(inputs):
    rows = inputs.table("rock-activity")
    if rows is None:
        return style.only_words("how often a step takes its branches")
    flow, n = Flow(4, 8.5), Counts(rows)
    for lane in (draw_step, draw_find, draw_update, draw_move):
        lane(flow, n)
    said = "; ".join(f"{r['run']}: {r['steps']} steps, {groups(r)} groups, {r['vertices'] // r['steps']} vertices" for r in rows)
    flow.axes.text(0.5 * flow.size[0], -flow.size[1] + 0.2, f"counts of {'  |  '.join(r['run'] for r in rows)}.  {said}", fontsize=8, color=style.BLUE, ha="center")
    return flow.figure
