"""make.py OUT: figure.png, how step times are distributed before and after, and table.md, the CSV files of this study."""

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

TABLES = {"phases_before.csv": "Instructions by phase, counted, before.", "phases.csv": "The same after.",
          "threads.csv": "Wall time of the phases on one and two threads, us a step.",
          "lists.csv": "Near lists and one classification of touched triangles: least of the runs' medians (their median).",
          "parts.csv": "The same change by parts of a step of the standard workload at 1.0 mm (10th percentile of 500 steps, timers included).",
          "one_scan.csv": "One scan for sweeping and touching, later and on a quieter machine: least of the runs' medians (their median)."}
PANELS = {"standard-1.0": "standard workload at 1.0 mm", "standard-0.7-volumes": "0.7 mm, volumes only", "drill-bit-b": "drill-bit-b"}


def draw(path):
    figure, axes = style.panels(len(PANELS), 1, (7.0, 6.6), sharex=True)
    for ax, (workload, title) in zip(axes, PANELS.items()):
        for file, name, colour in (("histogram_before.csv", "before", style.GREY), ("histogram.csv", "after", style.BLUE)):
            times, *_ = (rows := read_csv(HERE / file)).values()
            counts = rows[workload]
            ax.step(times, [100.0 * c / sum(counts) for c in counts], where="post", color=colour, label=name)
        ax.set(ylabel="steps (%)", xlim=(0.0, 6.0), title=title)
    axes[0].legend(loc="upper right")
    axes[-1].set_xlabel("time of a step over the mean of the height field of 0.5 mm")
    figure.savefig(path, dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    out = Path(sys.argv[1])
    write_tables(HERE, TABLES, out)
    draw(out / "figure.png")
