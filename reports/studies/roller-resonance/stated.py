"""The numbers of README.md, from the data of this study."""

from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["100 m of pipe and 90 m of collars", "3 m/h", "85 degrees", "edges of 4 mm", "edges of 1.6 mm", "steps of 1 ms", "1.5 s to 3.5 s", "edges of 2.8 mm",
         "110 rpm", "above 110 rpm"]


def stated():
    speeds = read_rows(HERE / "speeds.csv")
    mode = read_rows(HERE / "modes.csv")[0]["axial_hz"]
    rows = [r for r in speeds if r["rock"] == "boundary" and r["edge_mm"] == 4.0]
    [even] = [r for r in speeds if r["rock"] == "even"]
    [finer] = [r for r in speeds if r["edge_mm"] == 2.8]
    yield "an axial vibration of {:.2f} Hz when the bit is free, which three lobes a turn meet at {:.0f} rpm", mode, 20.0 * mode
    least, most = (f(rows, key=lambda r: r["weight_line_n"]) for f in (min, max))
    yield "least at {:.0f} rpm, {:.2f} kN, while the bit moves by {:.2f} mm", least["rpm"], 1e-3 * least["weight_line_n"], least["displacement_line_mm"]
    slow = min(rows, key=lambda r: r["rpm"])
    yield "At {:.0f} rpm it is {:.1f} kN with {:.2f} mm", slow["rpm"], 1e-3 * slow["weight_line_n"], slow["displacement_line_mm"]
    low = [r for r in rows if r["rpm"] <= 110.0]
    yield "from {:.2f} to {:.2f} kN/mm, within {:.2f} kN/mm of it", max(r["stiffness_kn_mm"] for r in low), min(r["stiffness_kn_mm"] for r in low), \
        max(abs(r["stiffness_kn_mm"] - r["stiffness_of_rods_kn_mm"]) for r in low)
    zero = [(a, b) for a, b in zip(low, low[1:]) if a["stiffness_kn_mm"] > 0.0 >= b["stiffness_kn_mm"]]
    [(a, b)] = zero
    share = a["stiffness_kn_mm"] / (a["stiffness_kn_mm"] - b["stiffness_kn_mm"])
    yield "passes zero at {:.2f} Hz", a["excitation_hz"] + share * (b["excitation_hz"] - a["excitation_hz"])
    yield "largest at {:.0f} rpm, {:.1f} Hz: the bit moves by {:.1f} mm, its weight by {:.0f} kN about a mean of {:.0f} kN", most["rpm"], most["excitation_hz"], \
        most["displacement_line_mm"], 1e-3 * most["weight_line_n"], 1e-3 * most["weight_mean_n"]
    yield "hook load by {:.0f} kN", 1e-3 * most["hook_load_line_n"]
    yield "{:.1f} mm and {:.0f} kN with edges of 2.8 mm", finer["displacement_line_mm"], 1e-3 * finer["weight_line_n"]
    yield "Even sandstone moves the bit by {:.1f} mm", even["displacement_line_mm"]
    off = [100.0 * abs(r["stiffness_kn_mm"] / r["stiffness_of_rods_kn_mm"] - 1.0) for r in rows if r["rpm"] > 110.0]
    yield "by {:.0f} % and {:.0f} % there", *off
