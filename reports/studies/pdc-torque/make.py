"""make.py OUT: the tables and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_rows  # noqa: E402

TABLES = {"torque.csv": "Means of the third revolution over the exact values eps R^2 d/2 and pi R^2 d."}
COLOURS = {"A": style.BLUE, "B": style.RED, "C": style.GREY}


def draw(axes):
    rows = read_rows(HERE / "torque.csv")
    dashes = {1.0: "solid", 2.08: "dashed", 3.0: "dotted"}
    for bit, colour in COLOURS.items():
        for advance, dash in dashes.items():
            chosen = [r for r in rows if (r["bit"], r["advance, mm"], r["section lead"]) == (bit, advance, "default")]
            axes.plot([r["edges, mm"] for r in chosen], [100 * (r["work of a turn over exact"] - 1) for r in chosen], "o", linestyle=dash,
                      color=colour, label=f"bit {bit}, {advance:g} mm")
    former = [r for r in rows if r["section lead"] != "default"]
    axes.plot([r["edges, mm"] for r in former], [100 * (r["work of a turn over exact"] - 1) for r in former], "x:", color="black",
              label="bit C, 3 mm, lead 1.2")
    axes.axhspan(-0.2, 0.2, color=style.GREY, alpha=0.2, label="0.2 %")
    axes.set(xlabel="edge length, mm, and step, ms", ylabel="work of a turn less eps R$^2$ d/2, %", xlim=(0, None))
    axes.legend(fontsize="small")


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(1, 1, (7.0, 4.4))
    draw(axes[0] if hasattr(axes, "__len__") else axes)
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
