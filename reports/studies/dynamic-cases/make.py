"""make.py OUT: the tables and the figure of this study, from cases.csv and before.csv."""

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


def number(x):
    """Two digits; a change above 100 per cent says no more than that."""
    return ">100" if x > 100.0 else f"{x:.2g}"


def shipped_and_changes(row, scale):
    """The shipped value (to the finest step / to the finest edges, per cent)."""
    value = float(row["value"])
    changes = (abs(float(str(row[key]).split()[-1]) / value - 1.0) for key in ("by_step", "by_edge"))
    return f"{scale * value:.4g} ({' / '.join(number(100.0 * c) for c in changes)})"


def line_of(found, case, program, columns):
    cells = [shipped_and_changes(found[case, q], s) if (case, q) in found else "" for q, s in columns]
    return [case, program, *cells]


def compared(rows, before):
    """Both programs side by side: values and their changes to the finest levels."""
    now, then = ({(r["case"], r["quantity"]): r for r in table} for table in (rows, before))
    lines = []
    for case in dict.fromkeys(r["case"].partition(",")[0] for r in before):
        labels = dict.fromkeys(r["case"] for r in before if r["case"].partition(",")[0] == case)
        lines += [line_of(then, label, "before", THEN) for label in labels]
        lines.append(line_of(now, case, "now", NOW))
    return markdown_table(COMPARED, lines)


# What is reported as a rate now is displacement over time.
COMPARED = ["case", "program", "weight, kN", "torque, N m", "rate, mm/s", "`rop_mean` then, mm/s", "rotary speed, rad/s"]
THEN = [("wob_mean", 1e-3), ("tob_mean", 1.0), ("advance", 1e3), ("rop_mean", 1e3), ("rotary_speed_mean", 1.0)]
NOW = [("wob_mean", 1e-3), ("tob_mean", 1.0), ("rop_mean", 1e3), ("none", 1.0), ("rotary_speed_mean", 1.0)]
CAPTION = """
The program of commit 7b1ef44f (2026-11-27), before forces and resistances became one flow, on its shipped cases and the same
levels. Rates are displacements over time; `rop_mean` is what that program reported. In brackets: changes to the finest step
and to the finest edges, per cent.

"""


def draw(axes, rows, which, label):
    for name, colour in zip(dict.fromkeys(r["case"] for r in rows), COLOURS):
        row = next(r for r in rows if r["case"] == name and r["quantity"] == "rop_mean")
        sizes, values = (list(map(float, str(row[key]).split())) for key in (f"{which}s", f"by_{which}"))
        axes.plot([1e3 * s for s in sizes], [v / values[-1] for v in values], "o-", color=colour, label=name)
    axes.set(xscale="log", xlabel=label, ylabel="rate of penetration over that of the finest level")


COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD, style.SKY, style.BLACK, style.GREY, "#7f5f3f")


def main(out):
    rows = read_rows(HERE / "cases.csv")
    both = table(rows) + CAPTION + compared(rows, read_rows(HERE / "before.csv"))
    (Path(out) / "table.md").write_text(both, encoding="utf-8")
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
