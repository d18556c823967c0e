"""make.py OUT: the table and the figure of this study, from volumes.csv and runs.json."""

import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from figures import style  # noqa: E402
from study_tools import markdown_table, read_csv  # noqa: E402

FIRST = 1  # the revolution after the first: that one starts from a smooth bottom


def excess(run, volumes):
    """Volume of each revolution over pi R^2 d, less one, in percent."""
    advance = run["motion"]["rate_of_penetration"] * 2.0 * math.pi / run["motion"]["rotary_speed"]
    whole = math.pi * run["gage_radius_m"] ** 2 * advance
    return [100.0 * (v / whole - 1.0) for v in volumes]


def row(edge, run, values):
    rms = math.sqrt(sum(v * v for v in values[FIRST:]) / len(values[FIRST:]))
    return [edge, run["rock_triangles_end"], f"{rms:.3f}", f"{max(values[FIRST:], key=abs):+.3f}",
            f"{run['volume_ledger_defect']:.0e}", f"{run['rock_quality_min']:.2f}", f"{run['rock_quality_1_percent']:.2f}"]


def main(out):
    runs = json.loads((HERE / "runs.json").read_text(encoding="utf-8"))
    volumes = read_csv(HERE / "volumes.csv")
    by_edge = {edge: excess(run, volumes[f"m3 at {edge}"]) for edge, run in runs.items()}
    headings = ["edges", "triangles at the end", "rms, %", "farthest, %", "ledger defect", "worst quality", "1 % quantile"]
    out.mkdir(parents=True, exist_ok=True)
    (out / "table.md").write_text(markdown_table(headings, [row(e, runs[e], by_edge[e]) for e in runs]), encoding="utf-8")
    figure, axes = style.panels(1, 1, (7.0, 3.6))
    for (edge, values), colour in zip(by_edge.items(), (style.RED, style.GREEN, style.BLUE)):
        axes.plot(volumes["revolution"][FIRST:], values[FIRST:], "o-", color=colour, label=edge)
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    axes.set(xlabel="revolution", ylabel=r"volume over $\pi R^2 d$, less 1 (%)", xticks=range(2, 21, 2))
    axes.legend(title="edges")
    figure.savefig(out / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(Path(sys.argv[1]))
