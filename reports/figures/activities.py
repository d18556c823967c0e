"""Activity diagrams with counts, in place of figures 4.2, 4.3, 4.11, 4.13, 4.15, 4.17 and 4.20: actions, decisions and arrows on a grid."""

import numpy as np
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch, Polygon

from figures import results, style

# Draws activity diagrams: actions, decisions and arrows on a grid, with a count at each.

WIDE, HIGH = 2.1, 0.62  # of an action, inches
STEP = (2.9, 0.95)  # of the grid
MARGIN = 0.3  # at the left, for what goes back
ACTION, DECISION = (0.5 * WIDE, 0.5 * HIGH), (0.62 * WIDE, 0.36)  # halves
FONT = 7.5


class Flow:
    """Nodes are at (column, row), rows downwards. The text of a node is one string; its counts come below it."""

    def __init__(self, columns, rows):
        self.size, self.half = (columns * STEP[0] + MARGIN, rows * STEP[1]), {}
        self.figure = style.Figure(figsize=self.size)
        self.axes = self.figure.add_axes([0, 0, 1, 1])
        self.axes.set(xlim=(0, self.size[0]), ylim=(-self.size[1], 0))
        self.axes.set_axis_off()

    def place(self, column, row):
        return MARGIN + (column + 0.5) * STEP[0], -(row + 0.5) * STEP[1]

    def write(self, x, y, text, counts, colour=style.BLACK):
        self.axes.text(x, y + (0.09 if counts else 0), text, fontsize=FONT, color=colour, ha="center", va="center", linespacing=1.25)
        if counts:
            lines = text.count("\n") + 1
            self.axes.text(x, y - 0.03 - 0.075 * lines, counts, fontsize=FONT, color=style.BLUE, weight="bold", ha="center", va="center", linespacing=1.25)

    def action(self, column, row, text, counts=""):
        x, y = self.place(column, row)
        self.half[column, row] = ACTION
        self.axes.add_patch(FancyBboxPatch((x - 0.5 * WIDE + 0.06, y - 0.5 * HIGH + 0.06), WIDE - 0.12, HIGH - 0.12, boxstyle="round,pad=0.06",
                                           facecolor="#eef2f6", edgecolor=style.GREY, linewidth=0.8))
        self.write(x, y, text, counts)

    def decision(self, column, row, text):
        x, y = self.place(column, row)
        self.half[column, row] = wide, high = DECISION
        self.axes.add_patch(Polygon([(x, y + high), (x + wide, y), (x, y - high), (x - wide, y)], facecolor="#fff4d6",
                                    edgecolor=style.GREY, linewidth=0.8))
        self.write(x, y, text, "")

    def end(self, column, row, text, counts=""):
        """What leaves the diagram."""
        self.write(*self.place(column, row), text, counts, style.GREY)

    def title(self, column, row, text):
        x, y = self.place(column, row)
        self.axes.text(x, y, text, fontsize=9.5, weight="bold", ha="center", va="center")

    def line(self, start, end):
        self.axes.add_patch(FancyArrowPatch(start, end, arrowstyle="-|>", mutation_scale=8, linewidth=0.9, color=style.BLACK, shrinkA=0, shrinkB=0))

    def below(self, column, row, label=""):
        """An arrow to the node of the next row."""
        (x, y0), (_, y1) = self.place(column, row), self.place(column, row + 1)
        y0, y1 = y0 - self.half[column, row][1], y1 + self.half[column, row + 1][1]
        self.line((x, y0), (x, y1))
        self.axes.text(x + 0.08, 0.5 * (y0 + y1), label, fontsize=FONT, color=style.GREY, ha="left", va="center")

    def beside(self, column, row, label=""):
        """An arrow to the next column."""
        (x0, y), (x1, _) = self.place(column, row), self.place(column + 1, row)
        x0, x1 = x0 + self.half[column, row][0], x1 - self.half.get((column + 1, row), (0.8, 0))[0]
        self.line((x0, y), (x1, y))
        self.axes.text(0.5 * (x0 + x1), y + 0.06, label, fontsize=FONT, color=style.GREY, ha="center", va="bottom")

    def back(self, column, row, to, side, label=""):
        """A loop back up to the row `to`, on the left (-1) or right (1)."""
        (x, y0), (_, y1) = self.place(column, row), self.place(column, to)
        out = x + side * (DECISION[0] + 0.1)
        self.axes.plot([x + side * self.half[column, row][0], out, out], [y0, y0, y1], color=style.BLACK, linewidth=0.9)
        self.line((out, y1), (x + side * self.half[column, to][0], y1))
        self.axes.text(out + side * 0.06, 0.5 * (y0 + y1), label, fontsize=FONT, color=style.GREY, rotation=90, ha="left" if side > 0 else "right",
                       va="center")


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


def cutting_activity(inputs):
    """In place of figures 4.2, 4.3, 4.11 and 4.13: the step of TDBD as activities, with how often runs took each branch."""
    rows = inputs.table("rock-activity")
    if rows is None:
        return style.only_words("how often a step takes its branches")
    flow, n = Flow(4, 8.5), Counts(rows)
    for lane in (draw_step, draw_find, draw_update, draw_move):
        lane(flow, n)
    said = "; ".join(f"{r['run']}: {r['steps']} steps, {groups(r)} groups, {r['vertices'] // r['steps']} vertices" for r in rows)
    flow.axes.text(0.5 * flow.size[0], -flow.size[1] + 0.2, f"counts of {'  |  '.join(r['run'] for r in rows)}.  {said}", fontsize=8, color=style.BLUE, ha="center")
    return flow.figure


def walk_activity(inputs):
    """In place of figure 4.15: the walk over a part's facets to the exit of a vertex, with how often it took each branch."""
    rows = inputs.table("walk-activity")
    if rows is None:
        return style.only_words("walks to the exit")
    [n] = rows
    flow = Flow(2, 6)
    flow.action(0, 0, "vertex, path and update direction", str(n["queries"]))
    flow.decision(0, 1, "near the part's box?")
    flow.action(0, 2, "walk from the last facet, across\nthe edge that is missed most", str(n["tried"]))
    flow.decision(0, 3, "a facet where it leaves?")
    flow.action(0, 4, "facets up to a little beyond it")
    flow.action(0, 5, "exit, or not swept", f"{n['swept']} swept")
    flow.end(1, 1, "not swept", str(n["queries"] - n["tried"]))
    flow.action(1, 3, "first facet by the tree of boxes", str(n["tried"] - n["found"]))
    flow.action(1, 4, "search by the tree of boxes", str(n["tried"] - n["answered"]))
    for row, label in enumerate(("", "yes", "", f"yes: {n['found']}", f"enough: {n['answered']}")):
        flow.below(0, row, label)
    flow.beside(0, 1, "no")
    flow.beside(0, 3, "no")
    flow.beside(0, 4, "not enough")
    return flow.figure


def in_words(key):
    return key.replace("refused_", "refused: ").replace("_", " ")


def maintenance_activity(inputs):
    """In place of figures 4.17 and 4.20: how often maintenance took each branch of its activity, over long runs."""
    runs = [results.summary(folder) for folder in inputs.folders()]
    counters = [run["counters"]["maintenance"] for run in runs]
    keys = [k for k in counters[0] if any(c.get(k) for c in counters)]
    keys.sort(key=lambda k: (k.startswith("refused"), k))
    figure, axes = style.panels(1, 1, (7.6, 0.7 + 0.42 * len(keys)))
    height = 0.8 / len(runs)
    for k, (run, colour) in enumerate(zip(runs, (style.BLUE, style.RED, style.GREEN))):
        counts = np.array([counters[k].get(key, 0) for key in keys])
        places = np.arange(len(keys)) + (k - 0.5 * (len(runs) - 1)) * height
        axes.barh(places, counts, height, color=colour, label=f"{run['title']}, {run['revolutions']:.3g} revolutions")
        for place, count in zip(places, counts):
            axes.annotate(str(count), (max(count, 1), place), xytext=(3, 0), textcoords="offset points", va="center", fontsize=7)
    axes.set_yticks(np.arange(len(keys)), [in_words(k) for k in keys])
    axes.invert_yaxis()
    axes.set(xscale="log", xlabel="count over the whole run", xlim=(0.8, 4 * max(max(c.values()) for c in counters)))
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=len(runs))
    return figure
