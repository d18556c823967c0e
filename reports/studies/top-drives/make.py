"""make.py OUT: figure.png, the bit and the surface under three top drives, and table.md with all runs."""

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
from study_tools import read_csv, read_rows  # noqa: E402

TABLES = {"runs.csv": "The 3-D bit from 15 s on.", "torque.csv": "Torque of bit B over its speed, stiff top.", "simple.csv": "The bit of two levels on the same string."}
COLOURS = {"stiff": style.RED, "soft-torque": style.BLUE, "z-torque": style.GREEN}


def draw(path):
    traces, reflection = (read_csv(HERE / f"{name}.csv") for name in ("traces", "reflection"))
    figure, axes = style.panels(3, 1, (8.0, 8.4))
    for top, colour in COLOURS.items():
        axes[0].plot(traces["time_s"], traces[f"{top}_bit_rpm"], color=colour, label=top)
        axes[1].plot(traces["time_s"], traces[f"{top}_surface_torque_kn_m"], color=colour, label=top)
        axes[2].plot(reflection["frequency_hz"], reflection[top], color=colour, label=top)
    axes[0].set(ylabel="rotary speed of the bit (rpm)", ylim=(None, 250.0))
    axes[0].legend(loc="upper right", ncols=3)
    axes[1].set(xlabel="time (s)", ylabel="torque at the surface (kN m)")
    period = next(float(r["period_s"]) for r in read_rows(HERE / "runs.csv") if r["top"] == "stiff")
    axes[2].axvline(1.0 / period, color=style.GREY, linestyle="--", linewidth=1.0)
    axes[2].annotate("stick-slip under\nthe stiff top", (1.0 / period, 0.45), xytext=(4, 0), textcoords="offset points", color=style.GREY, fontsize=8)
    axes[2].set(xscale="log", xlabel="frequency (Hz)", ylabel="reflection of waves at the top", ylim=(0.0, 1.05))
    figure.savefig(path, dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    out = Path(sys.argv[1])
    write_tables(HERE, TABLES, out)
    draw(out / "figure.png")
