"""make.py OUT: the table and the figure of this study, from cases.csv."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from figures import style  # noqa: E402
from study_tools import markdown_table, read_rows  # noqa: E402

HEADINGS = ["case", "quantity", "shipped", "by step", "order", "by edges", "order", "by sampling"]
SHOWN = ["wob_mean", "tob_mean", "rop_mean", "rotary_speed_mean", "cone_speed_ratios", "torsional_frequency",
         "stick_slip_severity", "orbit_radius", "orbit_frequency"]


def order(row, which):
    """The observed order; in brackets the slope of differences that have not settled on one."""
    if row[f"order_{which}"]:
        return f"{float(row[f'order_{which}']):.1f}"
    slope = row[f"slope_{which}"]
    return f"({float(slope):.1f})" if slope else "-"


def table(rows):
    lines = []
    for r in rows:
        if r["quantity"] in SHOWN:
            sampling = r["uncertainty_sampling"]
            lines.append([r["case"], f"{r['quantity']}, {r['unit']}", f"{float(r['value']):.5g}", f"{float(r['uncertainty_step']):.2g}",
                          order(r, "step"), f"{float(r['uncertainty_edge']):.2g}", order(r, "edge"),
                          f"{float(sampling):.2g}" if sampling else ""])
    return markdown_table(HEADINGS, lines)


def draw(axes, rows, which, label):
    for name, colour in zip(dict.fromkeys(r["case"] for r in rows), COLOURS):
        row = next(r for r in rows if r["case"] == name and r["quantity"] == "rop_mean")
        sizes, values = (list(map(float, str(row[key]).split())) for key in (f"{which}s", f"by_{which}"))
        axes.plot([1e3 * s for s in sizes], [v / values[-1] for v in values], "o-", color=colour, label=name)
    axes.set(xscale="log", xlabel=label, ylabel="rate of penetration over that of the finest level")


COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD, style.SKY, style.BLACK, style.GREY, "#7f5f3f")


def main(out):
    rows = read_rows(HERE / "cases.csv")
    (Path(out) / "table.md").write_text(table(rows), encoding="utf-8")
    # A bouncing bit advances by next to nothing.
    drawn = [r for r in rows if r["case"] != "bit-bounce"]
    figure, axes = style.panels(1, 2, (10.0, 4.6))
    left, right = axes.ravel()
    draw(left, drawn, "step", "time step, ms")
    draw(right, drawn, "edge", "edge length, mm")
    right.legend()
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
