"""make.py OUT: the tables and the figure of this study, from its CSV files."""

import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402
from figures import style  # noqa: E402
from study_tools import read_csv  # noqa: E402

TABLES = {"orders.csv": "Observed order in the edge length over five levels (least squares of the error), and the force at 0.4 mm over the exact one.",
          "contacts.csv": "Force over exact force, by edge length; the scatter is the standard deviation over the slide.",
          "bit-r.csv": "Bit R at 8 m/h, means of 0.67 to 1 s.",
          "cycle.csv": "Stick and slip on pads under 100 kN."}


def lines_of(table, contact, column):
    chosen = [i for i, name in enumerate(table["contact"]) if name == contact]
    return [table["edges, mm"][i] for i in chosen], [table[column][i] for i in chosen]


def draw_contacts(axes):
    table = read_csv(HERE / "contacts.csv")
    for contact, dashes in (("ball", "solid"), ("milled tooth yawed 20 deg", "dashed")):
        for column, colour in (("weight", style.BLUE), ("drag", style.RED)):
            axes.plot(*lines_of(table, contact, column), "o", linestyle=dashes, color=colour, label=f"{contact.split(' yawed')[0]}, {column}")
    before = read_csv(HERE / "ball-before.csv")
    for column, colour in (("weight", style.BLUE), ("drag", style.RED)):
        axes.plot(*lines_of(before, "ball", column), "x", linestyle="dotted", color=colour, label=f"ball, {column}, before")
    axes.axhline(1.0, color=style.GREY, linewidth=1.0)
    axes.set(title="sliding contacts", xlabel="edge length, mm", ylabel="force over exact force", xlim=(0, None))
    axes.legend()


def draw_bit(axes):
    for name, marks, word in (("bit-r.csv", "o-", ""), ("bit-r-before.csv", "x:", ", before")):
        table = read_csv(HERE / name)
        chosen = [i for i, step in enumerate(table["step, ms"]) if step == 1.0]
        for column, colour, scale in (("weight, kN", style.BLUE, 1.0), ("torque, N m", style.RED, 0.1)):
            axes.plot([table["edges, mm"][i] for i in chosen], [scale * table[column][i] for i in chosen], marks, color=colour,
                      label=column.replace("N m", "10 N m") + word)
    axes.set(title="bit R at 8 m/h, steps of 1 ms", xlabel="edge length, mm", xlim=(0, None), ylim=(0, None))
    axes.legend()


def closed_speed(time):
    """Of friction that falls at once: breakaway at time 0, over the mean."""
    table = read_csv(HERE / "cycle.csv")
    last = -1
    slip, period, peak = (float(table[name][last]) for name in ("slip, s", "period, s", "peak over mean"))
    time = np.where(time > 0.0, time % period, time)
    frequency, deviation = 1.4561, peak - 1.0  # rad/s: sqrt(611.9/288.6)
    phase = np.arccos(-1.0 / deviation)
    wave = 1.0 + deviation * np.cos(frequency * time - phase)
    return np.where((time > 0) & (time < slip), wave, 0.0)


def draw_cycle(axes):
    trace = read_csv(HERE / "cycle-trace.csv")
    time = np.array(trace["time, s"])
    axes.plot(time, trace["speed over mean"], color=style.BLUE, label="TDBD")
    axes.plot(time, closed_speed(time), color=style.RED, linestyle="dashed", label="closed form")
    axes.set(title="stick and slip on pads", xlabel="time after breakaway, s", ylabel="rotary speed over mean")
    axes.legend()


def main(out):
    write_tables(HERE, TABLES, out)
    figure, axes = style.panels(1, 3, (12.0, 3.8))
    for draw, one in zip((draw_contacts, draw_bit, draw_cycle), np.ravel(axes)):
        draw(one)
    figure.savefig(Path(out) / "figure.png", dpi=style.DPI, metadata={"Software": None})


if __name__ == "__main__":
    main(sys.argv[1])
