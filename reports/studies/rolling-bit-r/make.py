"""make.py OUT: the table and the figure of this study, from cone_speeds.csv, rows.csv and run.json."""

import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from figures import style  # noqa: E402
from study_tools import markdown_table, read_csv  # noqa: E402


def ratios_of(rows, cone):
    """Rolling ratios of a cone's rows; a row at the apex has none."""
    return [r for c, r in zip(rows["cone"], rows["rolling_ratio"]) if c == cone and r > 0.0]


def row(cone, rows):
    ratios = ratios_of(rows, cone["name"])
    return [cone["name"], f"{cone['mean_speed_ratio']:.3f}", f"{cone['std_speed_ratio']:.3f}",
            f"{min(ratios):.3f} to {max(r for r in ratios if r < cone['rolling_ratio_gage_row']):.3f}",
            f"{cone['rolling_ratio_gage_row']:.3f}", f"{cone['net_slip_gage_row']:.3f}"]


def main(out):
    run = json.loads((HERE / "run.json").read_text(encoding="utf-8"))
    speeds, rows = read_csv(HERE / "cone_speeds.csv"), read_csv(HERE / "rows.csv")
    headings = ["cone", "mean speed over the bit's", "standard deviation", "inner rows would roll at", "gage row would roll at",
                "net slip of the gage row"]
    out.mkdir(parents=True, exist_ok=True)
    (out / "table.md").write_text(markdown_table(headings, [row(c, rows) for c in run["cones"]]), encoding="utf-8")
    figure, axes = style.panels(1, 1, (7.0, 3.6))
    for cone, colour in zip(run["cones"], style.CONES):
        axes.plot(speeds["revolution"], speeds[cone["name"]], "o-", color=colour, label=cone["name"])
    axes.axhline(run["cones"][0]["rolling_ratio_gage_row"], color=style.GREY, linestyle="dashed", linewidth=1.0, label="gage row rolls")
    axes.set(xlabel="revolution", ylabel="speed of the cone over the bit's", xticks=range(0, len(speeds["revolution"]) + 1, 2))
    axes.legend()
    figure.savefig(out / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(Path(sys.argv[1]))
