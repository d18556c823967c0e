"""make.py OUT: the tables and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_rows  # noqa: E402

TABLES = {"flats.csv": "Worn volume of sharp cutters that wear at their flats alone, all but those at the gage, over edges and the rim "
                       "segments of a cutter, beside the half-planes.",
          "convergence.csv": "Worn volume of the case wear-bit-b over edges, steps, wear steps and acceleration.",
          "cutters.csv": "Bit B after 100 m: flats and temperatures of TDBD and of Glowka's model.",
          "wear_steps.csv": "Worn volume of the case wear-bit-b over the time steps between two wear steps.",
          "metres.csv": "Weight at a constant rate and rate at a constant weight over metres.",
          "layouts.csv": "Layouts of a designed bit after 50 m, by the scatter of their cutters' worn volumes."}
ROCKS = {"medium": style.BLUE, "hard": style.RED}


def draw_metres(axes, drive, quantity, label):
    for rock, colour in ROCKS.items():
        for source, dash in (("TDBD", "solid"), ("Glowka's model", "dashed")):
            rows = [r for r in read_rows(HERE / "metres.csv") if (r["rock"], r["source"]) == (rock, f"{source}, constant {drive}")]
            axes.plot([r["metres"] for r in rows], [r[quantity] for r in rows], color=colour, linestyle=dash, label=f"{source}, {rock} rock")
    axes.set(xlabel="metres drilled", ylabel=label, title=f"at a constant {drive}")


def draw_flats(axes):
    for rock, colour in ROCKS.items():
        rows = [r for r in read_rows(HERE / "cutters.csv") if r["rock"] == rock]
        number = range(1, len(rows) + 1)
        axes.plot(number, [r["flat of TDBD, mm2"] for r in rows], "o", color=colour)
        axes.plot(number, [r["flat of Glowka's model, mm2"] for r in rows], "x", color=style.GREY)
    axes.set(xlabel="cutter, from the axis to the gage", ylabel="flat after 100 m, mm²", title="TDBD (dots), Glowka's model (crosses)")


def draw_layouts(axes):
    rows = read_rows(HERE / "layouts.csv")
    scatter, energy = "scatter of worn volumes over their mean", "specific energy, MPa"
    front = [r for r in rows if r["on the front"] == "yes"]
    axes.plot([r[scatter] for r in rows], [r[energy] for r in rows], "o", color=style.GREY)
    axes.plot([r[scatter] for r in front], [r[energy] for r in front], "o-", color=style.BLUE)
    axes.set(xlabel=scatter, ylabel=energy, title="32 layouts after 50 m; the front of both goals")


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(2, 2, (11.0, 8.0))
    draw_flats(axes[0, 0])
    draw_layouts(axes[0, 1])
    draw_metres(axes[1, 0], "rate", "weight on bit, kN", "weight on bit, kN")
    draw_metres(axes[1, 1], "weight", "rate of penetration, m/h", "rate of penetration, m/h")
    axes[1, 0].legend()
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
