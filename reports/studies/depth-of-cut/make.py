"""make.py OUT: weight.png, weight over depth of cut of bit B with the part of its body, and the tables of this study."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
import system_python  # noqa: E402

system_python.require("matplotlib")

import matplotlib  # noqa: E402

matplotlib.use("Agg")
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_csv  # noqa: E402

TABLES = {"runs.csv": "Weight of bit B over depth of cut, edges of 2 mm: on the body and in all.",
          "edges.csv": "The same at one depth of cut over edge lengths."}


def draw(path):
    plan, runs = (read_csv(HERE / f"{name}.csv") for name in ("plan", "runs"))
    figure, axes = style.panels(1, 1, (7.4, 3.4))
    for key, colour, what in (("weight_n", style.BLUE, "all"), ("body_weight_n", style.RED, "the body")):
        axes.plot(plan["depth_of_cut_mm"], [1e-3 * w for w in plan[key]], color=colour, label=f"{what}: radial plane")
        axes.plot(runs["depth_of_cut_mm"], [1e-3 * w for w in runs[key]], "o", color=colour, label=f"{what}: runs")
    axes.set(xlabel="depth of cut (mm/rev)", ylabel="weight (kN)", xlim=(0, None), ylim=(0, None))
    axes.legend(loc="upper left")
    figure.savefig(path, dpi=120, bbox_inches="tight")


if __name__ == "__main__":
    out = Path(sys.argv[1])
    write_tables(HERE, TABLES, out)
    draw(out / "weight.png")
