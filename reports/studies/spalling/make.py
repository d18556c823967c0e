"""make.py OUT: the tables and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_rows  # noqa: E402

sys.path.insert(0, str(HERE))
from grooves import Rock  # noqa: E402

TABLES = {"grooves.csv": "One groove in flat rock, 3 mm deep.",
          "neighbours.csv": "The second of two grooves.",
          "bit.csv": "Bit B, the third turn at 5 mm a turn.",
          "rows.csv": "The measured comparisons of validation, with break-out and without."}
COLOURS = {0.0: style.GREY, 60.0: style.BLUE, 70.0: style.RED}


def draw_groove(axes):
    for angle, colour in COLOURS.items():
        rock = Rock()
        rock.groove(0.0, angle, 1.0, 0.0)
        near = np.abs(rock.y) < 10e-3
        axes.plot(1e3 * rock.y[near], -1e3 * rock.bottom[near], color=colour, label=f"{angle:.0f} degrees" if angle else "none")
    axes.set(xlabel="across the path, mm", ylabel="height, mm", title="a groove and its cracks", ylim=(-3.2, 1.2))
    axes.legend(loc="upper center", ncols=3)


def draw_neighbours(axes):
    rows = read_rows(HERE / "neighbours.csv")
    for angle, colour in COLOURS.items():
        of_angle = [r for r in rows if r["angle, degrees"] == angle]
        spacing = [r["spacing, mm"] for r in of_angle]
        axes.plot(spacing, [r["exact, mm2"] for r in of_angle], color=colour)
        axes.plot(spacing, [r["section of the second groove, mm2"] for r in of_angle], "o", color=colour)
    axes.set(xlabel="spacing, mm", ylabel="section of the second groove, mm2", title="lines: exact; dots: TDBD")


def draw_errors(axes):
    rows = [r for r in read_rows(HERE / "grooves.csv") if r["step, ms"] == 2.0]
    for angle, share, ahead, marker in ((0.0, 0.0, 0.0, "s"), (60.0, 1.0, 0.0, "o"), (70.0, 1.0, 0.0, "^"), (70.0, 0.5, 0.0, "v"),
                                        (70.0, 1.0, 0.5, "d")):
        of = [r for r in rows if (r["angle, degrees"], r["depth share"], r["ahead share"]) == (angle, share, ahead)]
        label = f"{angle:.0f} degrees, {share:g}, ahead {ahead:g}" if angle else "none"
        axes.loglog([r["edge, mm"] for r in of], [abs(r["error"]) for r in of], marker=marker, label=label)
    axes.set(xlabel="edge length, mm", ylabel="relative error of the area that leaves", title="convergence")
    axes.legend()


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(1, 3, (15.0, 4.6))
    for draw, where in zip((draw_groove, draw_neighbours, draw_errors), axes.ravel(), strict=True):
        draw(where)
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
