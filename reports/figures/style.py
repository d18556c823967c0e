"""How the figures look: colours that survive colour blindness, one for each drift."""

import matplotlib
from matplotlib.figure import Figure
from matplotlib.patches import Circle

BLUE, RED, GREEN, PURPLE = "#0072B2", "#D55E00", "#009E73", "#B3569B"
GOLD, SKY, BLACK, GREY = "#E69F00", "#56B4E9", "#1d2733", "#8593a3"
DPI = 200  # of rendered pictures, as drawing.py saves them
XYZ = {"x": BLUE, "y": RED, "z": GREEN}
CONES = (PURPLE, GOLD, SKY)

# name in a case: (label, colour, marker)
DRIFTS = {
    "lie-midpoint": ("Lie midpoint (thesis, reconstructed)", RED, "^"),
    "lie-mean": ("Lie mean", PURPLE, "D"),
    "three-axis": ("three-axis", GREEN, "s"),
    "split": ("split (default)", BLUE, "o"),
}

matplotlib.rcParams.update({
    "font.size": 9, "axes.titlesize": 9.5, "axes.labelsize": 9, "legend.fontsize": 8,
    "legend.frameon": False, "lines.linewidth": 1.3, "lines.markersize": 4, "axes.grid": True,
    "grid.color": "0.9", "axes.axisbelow": True, "axes.spines.top": False, "axes.spines.right": False,
    "axes.formatter.useoffset": False, "axes.formatter.limits": (-3, 5)})


def panels(rows, columns, size, **options):
    """A figure of this size (inches) and its axes."""
    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, **options)


def circle(radius):
    """A thin ring about the origin."""
    return Circle((0, 0), radius, fill=False, color="0.8", linewidth=0.8)


def say_missing(axes, what):
    """The note of a part that is not measured in a quick run."""
    axes.text(0.5, 0.5, f"{what}:\nnot measured in this run", transform=axes.transAxes, ha="center",
              va="center", color=GREY)


def only_words(what):
    """A figure with a note that it could not be drawn in a quick run."""
    figure, axes = panels(1, 1, (7.0, 4.0))
    say_missing(axes, what)
    return figure
