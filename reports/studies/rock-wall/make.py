"""make.py OUT: the table and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_csv, read_rows  # noqa: E402

TABLES = {"walls.csv": "Means of the second half of one second."}
COLOURS = {"rock": style.RED, "ring": style.BLUE}


def draw_orbits(axes):
    rows = read_rows(HERE / "orbits.csv")
    for wall, colour in COLOURS.items():
        of_wall = [r for r in rows if r["wall"] == wall]
        axes.plot([r["x, mm"] for r in of_wall], [r["y, mm"] for r in of_wall], color=colour, linewidth=0.8, label=wall)
    axes.set(xlabel="x, mm", ylabel="y, mm", aspect="equal", title="bit's nose, last tenth of a second")
    axes.legend()


def draw_section(axes):
    section = read_csv(HERE / "sections.csv")
    axes.plot(section["azimuth, deg"], section["radius, mm"], color=COLOURS["rock"], linewidth=0.9)
    axes.axhline(110.95, color=style.GREY, linewidth=1.0)
    axes.set(xlabel="azimuth, degrees", ylabel="radius of the hole, mm", title="at the middle of the pads, at the end")


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(1, 2, (10.0, 4.4))
    left, right = axes.ravel()
    draw_orbits(left)
    draw_section(right)
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
