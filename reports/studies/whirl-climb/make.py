"""make.py OUT: the tables and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_rows  # noqa: E402

TABLES = {"climb.csv": "Means of the second half of one second, by string.",
          "steps.csv": "Advance of the same time over the time step.",
          "steps-before.csv": "The same before forces and resistances were one flow."}
# file, case, marks, colour, label
CURVES = [("steps.csv", "shipped", "o-", style.BLUE, "shipped case, 1.5 mm"),
          ("steps.csv", "climbing", "o-", style.RED, "climbing bit, 3 mm"),
          ("steps-before.csv", "climbing", "x:", style.RED, "climbing bit, 3 mm, before")]


def draw(axes):
    for name, case, marks, colour, label in CURVES:
        rows = [r for r in read_rows(HERE / name) if r["case"] == case]
        axes.plot([r["step, ms"] for r in rows], [r["advance, mm/s"] for r in rows], marks, color=colour, label=label)
    axes.axhline(0.0, color=style.GREY, linewidth=1.0)
    axes.set(xscale="log", xlabel="time step, ms", ylabel="advance, mm/s")
    axes.legend()


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(1, 1, (7.0, 4.4))
    draw(axes[0] if hasattr(axes, "__len__") else axes)
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
