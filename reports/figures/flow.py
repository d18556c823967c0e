"""Draws activity diagrams: actions, decisions and arrows on a grid, with a count at each."""

from matplotlib.patches import FancyArrowPatch, FancyBboxPatch, Polygon

from figures import style

WIDE, HIGH = 2.1, 0.62  # of an action, inches
STEP = (2.9, 0.95)  # of the grid
MARGIN = 0.3  # at the left, for what goes back
ACTION, DECISION = (0.5 * WIDE, 0.5 * HIGH), (0.62 * WIDE, 0.36)  # halves
FONT = 7.5


class Flow:
    """Nodes stand at (column, row), rows downwards. The text of a node is one string; its counts come below it."""

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
        """An arrow to what stands in the next column."""
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
