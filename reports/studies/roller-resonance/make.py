"""make.py OUT: figure.png, the swing at three times the rotary speed over that frequency, and table.md."""

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
from study_tools import read_rows  # noqa: E402

TABLES = {"speeds.csv": "Bit R on the boundary of hard and soft rock, and in even rock.", "modes.csv": "Axial vibrations of the string, its bit free."}
LINES = (("displacement_line_mm", 1.0, "displacement\nof the bit (mm)", style.RED), ("weight_line_n", 1e-3, "weight on bit (kN)", style.GREEN),
         ("hook_load_line_n", 1e-3, "hook load (kN)", style.BLUE))


def draw(path):
    rows = read_rows(HERE / "speeds.csv")
    coarse = max(r["edge_mm"] for r in rows)
    boundary = [r for r in rows if r["rock"] == "boundary" and r["edge_mm"] == coarse]
    others = (("s", "finer edges", [r for r in rows if r["edge_mm"] != coarse]), ("x", "without the boundary", [r for r in rows if r["rock"] == "even"]))
    mode = float(read_rows(HERE / "modes.csv")[0]["axial_hz"])
    figure, axes = style.panels(4, 1, (7.0, 8.6), sharex=True)
    for ax, (key, scale, words, colour) in zip(axes, LINES):
        ax.plot([r["excitation_hz"] for r in boundary], [scale * r[key] for r in boundary], "o-", color=colour, label="on the boundary")
        for form, name, chosen in others:
            ax.plot([r["excitation_hz"] for r in chosen], [scale * r[key] for r in chosen], form, color=style.BLACK, label=name)
        ax.set(ylabel=words, ylim=(0.0, None))
    axes[3].plot([r["excitation_hz"] for r in boundary], [r["stiffness_kn_mm"] for r in boundary], "o", color=style.PURPLE, label="runs")
    axes[3].plot([r["excitation_hz"] for r in boundary], [r["stiffness_of_rods_kn_mm"] for r in boundary], "-", color=style.BLACK, label="rods, closed form")
    axes[3].axhline(0.0, color=style.GREY, linewidth=0.8)
    axes[3].set(ylabel="dynamic stiffness of\nthe string (kN/mm)", xlabel="three times the rotary speed (Hz)")
    for ax in axes:
        ax.axvline(mode, color=style.GREY, linestyle="--", linewidth=1.0, label=f"free vibration, {mode:.2f} Hz" if ax is axes[0] else None)
    axes[0].legend(loc="upper left")
    axes[3].legend(loc="lower left")
    axes[0].set_title("amplitudes at three times the rotary speed")
    figure.savefig(path, dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    out = Path(sys.argv[1])
    write_tables(HERE, TABLES, out)
    draw(out / "figure.png")
