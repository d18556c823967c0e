"""make.py OUT: figure.png, maps of severity, swing of weight and rate of the 3-D bit and of the simple bit, and table.md."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
import system_python  # noqa: E402

system_python.require("matplotlib", "numpy")

import matplotlib  # noqa: E402

matplotlib.use("Agg")
import numpy as np  # noqa: E402
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_rows  # noqa: E402

TABLES = {"map.csv": "Bit B in rock.", "simple.csv": "The regenerative bit at the same points.",
          "forces.csv": "Weight and torque of bit B at given depths of cut of a turn.", "levels.csv": "Points with other edges and steps."}
SHOWN = (("severity", "stick-slip severity", "magma_r", (0.0, 1.6)), ("weight_swing", "swing of weight", "viridis_r", (0.0, 0.6)),
         ("rate_mm_s", "rate (mm/s)", "cividis", (0.0, None)))


def grid(rows, key):
    """(weights, speeds, values[weight, speed])."""
    weights, speeds = (sorted({float(r[k]) for r in rows}) for k in ("weight_kn", "rpm"))
    found = {(float(r["weight_kn"]), float(r["rpm"])): float(r[key]) for r in rows}
    return weights, speeds, np.array([[found[w, s] for s in speeds] for w in weights])


def draw(path):
    maps = [("bit B in rock", read_rows(HERE / "map.csv")), ("regenerative bit", read_rows(HERE / "simple.csv"))]
    figure, axes = style.panels(2, 3, (11.0, 6.6))
    for column, (key, words, colours, (low, high)) in enumerate(SHOWN):
        top = high or max(np.nanmax(grid(rows, key)[2]) for _, rows in maps)
        for row, (name, rows) in enumerate(maps):
            ax = axes[row, column]
            weights, speeds, values = grid(rows, key)
            shown = ax.imshow(values, origin="lower", aspect="auto", cmap=colours, vmin=low, vmax=top)
            for i in range(len(weights)):
                for j in range(len(speeds)):
                    if np.isnan(values[i, j]):
                        ax.text(j, i, "stuck", ha="center", va="center", fontsize=7)
                        continue
                    dark = (values[i, j] - low) / (top - low)
                    pale = dark > 0.55 if colours.endswith("_r") else dark < 0.5
                    ax.text(j, i, f"{values[i, j]:.2f}" if key != "rate_mm_s" else f"{values[i, j]:.1f}", ha="center", va="center", fontsize=7,
                            color="white" if pale else style.BLACK)
            ax.set(xticks=range(len(speeds)), xticklabels=[f"{s:g}" for s in speeds], yticks=range(len(weights)),
                   yticklabels=[f"{w:g}" for w in weights], title=f"{name}: {words}")
            ax.grid(False)
            if row == 1:
                ax.set_xlabel("rotary speed of the top (rpm)")
            if column == 0:
                ax.set_ylabel("weight on bit (kN)")
        figure.colorbar(shown, ax=axes[:, column], shrink=0.7, extend="max" if high else "neither")
    figure.savefig(path, dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    out = Path(sys.argv[1])
    write_tables(HERE, TABLES, out)
    draw(out / "figure.png")
