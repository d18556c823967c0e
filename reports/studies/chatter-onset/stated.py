"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["120 rpm", "10 mm/s", "zeta 0.6", "eps 60 MPa", "of 10 t", "500 m of pipe", "edges of 1 mm", "on edges of 4 mm", "edges of 2.8 mm",
         "edges of 2 mm", "28 cutters", "Bit B on 2500 m", "edges of 2.1 mm", "near 3.5 Hz", "at 400 kN s/m", "damper of 400 kN s/m", "edges of 4.2 and 2.1 mm"]
THEORY, RUNS = "onset by theory, kN s/m", "onset of runs, kN s/m"


def of_flat_bit():
    flat, ahead = ({r["edge, mm"]: r for r in read_rows(HERE / name) if r["step, ms"] == 1.0} for name in ("flat.csv", "as-ahead.csv"))
    [limit] = read_rows(HERE / "limit.csv")
    yield "new rate, {:.0f} ms later", limit["delay, ms"]
    yield "begins at a damping of {:.0f} kN s/m", limit[THEORY]
    yield "to chatter at {:.0f} kN s/m and the roots at {:.0f}", flat[1.0][RUNS], flat[1.0][THEORY]
    yield "on edges of 4 mm at {:.0f} and {:.0f}", flat[4.0][RUNS], flat[4.0][THEORY]
    yield "differ by at most {:.0f} %", 100.0 * max(abs(r[RUNS] / r[THEORY] - 1.0) for r in flat.values())
    yield "the response jumps by {:.0f} kN s/m", ahead[4.0]["jump, kN s/m"]
    yield "vibration grows by {:.1f} per second on exact rock", limit["growth undamped by theory, 1/s"]
    yield "comes to rest, by {:.1f} per second", -ahead[4.0]["growth undamped by theory, 1/s"]
    yield "swings by {:.1f} %", 100.0 * ahead[4.0]["swing of an undamped run"]
    yield "swing by {:.0f} %", 100.0 * flat[4.0]["swing of an undamped run"]
    yield "the growth is {:.2f} per second", ahead[1.0]["growth undamped by theory, 1/s"]


def onset(rows, column):
    """Between the two dampings around it, kN s/m."""
    a, b = (next(r for r in rows if r["damping, kN s/m"] == d) for d in (200.0, 300.0))
    return 200.0 + 100.0 * a[column] / (a[column] - b[column])


def of_bit_b():
    rows = read_rows(HERE / "bit-b.csv")
    fine = {bodies: [r for r in rows if r["bodies"] == bodies and r["edge, mm"] == 2.1] for bodies in ("none", "bear")}
    yield ("damping of {:.0f} kN s/m by the roots and of {:.0f} kN s/m in runs",
           *(onset(fine["none"], f"growth {of}, 1/s") for of in ("by theory", "of the run")))
    yield "the roots say {:.0f} and the runs {:.0f} kN s/m", *(onset(fine["bear"], f"growth {of}, 1/s") for of in ("by theory", "of the run"))
    coarse = [r for r in rows if r["edge, mm"] == 4.2]
    last = [r for r in rows if r["edge, mm"] == 2.1]
    yield "alike within {:.2f} per second", max(abs(a["growth of the run, 1/s"] - b["growth of the run, 1/s"]) for a, b in zip(coarse, last, strict=True))
    growing = [r for r in rows if r["damping, kN s/m"] == 200.0]
    yield "agree within {:.1f} %", 100.0 * max(abs(r["frequency of the run, Hz"] / r["frequency by theory, Hz"] - 1.0) for r in growing)
    yield "another mode, near {:.1f} Hz", fine["none"][-1]["frequency of the run, Hz"]


def stated():
    yield from of_flat_bit()
    yield from of_bit_b()
