"""make.py OUT: the tables and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_rows  # noqa: E402

TABLES = {"flat.csv": "The flat bit with sections extrapolated to the face.",
          "limit.csv": "The same on exact rock.",
          "as-ahead.csv": "The flat bit with sections as they are ahead of the face.",
          "bit-b.csv": "Bit B on 2500 m of string, with pads, body and cutter bodies that bear, or without their friction."}
COLOURS = {4.0: style.GREY, 2.0: style.BLUE, 1.0: style.RED}


def draw_responses(axes):
    for sections, line in (("extrapolated", "-"), ("as_ahead", ":")):
        for edge, colour in COLOURS.items():
            rows = [r for r in read_rows(HERE / "response.csv") if r["sections"] == sections and r["edge, mm"] == edge]
            axes.plot([1e3 * r["time, s"] for r in rows], [1e-6 * r["change, N s/m"] for r in rows], line, color=colour,
                      label=f"{edge:g} mm, {sections}")
    limit = read_rows(HERE / "limit.csv")[0]
    jump, delay = 1e-3 * limit["jump, kN s/m"], limit["delay, ms"]
    axes.plot([0.0, delay, 250.0], [jump] + 2 * [jump + 1e-3 * delay * limit["stiffness, MN/m"]], "k--", linewidth=1.0, label="exact rock")
    axes.set(xlabel="time after the change, ms", ylabel="change of weight over that of rate, MN s/m", xlim=(0, 250))
    axes.legend(fontsize="small")


def draw_onsets(axes):
    for name, column, marks, colour, label in (
            ("flat.csv", "onset by theory, kN s/m", "o--", style.BLUE, "extrapolated, theory"),
            ("flat.csv", "onset of runs, kN s/m", "s-", style.BLUE, "extrapolated, runs"),
            ("as-ahead.csv", "onset by theory, kN s/m", "o--", style.RED, "as_ahead, theory")):
        rows = [r for r in read_rows(HERE / name) if r["step, ms"] == 1.0]
        axes.plot([r["edge, mm"] for r in rows], [r[column] for r in rows], marks, color=colour, label=label)
    axes.plot(0.0, read_rows(HERE / "limit.csv")[0]["onset by theory, kN s/m"], "k*", markersize=9, label="exact rock")
    axes.axhline(0.0, color=style.GREY, linewidth=1.0)
    axes.set(xlabel="edge length, mm", ylabel="damping at which chatter begins, kN s/m", xlim=(-0.1, None))
    axes.legend(fontsize="small")


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(1, 2, (11.0, 4.4))
    draw_responses(axes.flat[0] if hasattr(axes, "flat") else axes[0])
    draw_onsets(axes.flat[1] if hasattr(axes, "flat") else axes[1])
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
