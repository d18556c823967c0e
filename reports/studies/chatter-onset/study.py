"""The onset of axial chatter of bits on a chain, compared with the roots of their delay equation.

A flat bit with four equal blades on 500 m of pipe, and bit B on the string of cases/string-drill-bit-b.toml. A prescribed motion
measures the response of the weight to a change of rate. The roots of bit, rod and response are compared with runs.
"""

import itertools
import math
import shutil
from pathlib import Path

import numpy as np
from study_tools import ROOT, read_rows

HERE = Path(__file__).resolve().parent
YOUNG, DENSITY, MUD = 206e9, 7850.0, 0.1  # Pa, kg/m3, 1/s
FLAT = {"rate": 10e-3, "speed": 120, "mass": 1e4, "sections": [(500.0, 0.127, 0.1086)], "settled": 0.17,
        "dampings": (1.7e5, 2.3e5), "frequency": 6.45, "turn": 0.5}
BIT_B = {"rate": 5.4e-3, "speed": 120, "mass": 38.5, "sections": [(2300.0, 0.127, 0.1086), (200.0, 0.1651, 0.0714)],
         "settled": 0.6, "dampings": (2e5, 3e5, 4e5), "frequency": 3.55}
NONE = "".join(f'\n[forces.{kind}]\nlaw = "none"\n' for kind in ("cutter_body", "gage_pad", "bit_body"))
LEVELS = [(4.0, 1.0), (2.8, 1.0), (2.0, 1.0), (2.0, 0.5), (1.4, 1.0), (1.0, 1.0)]  # edges in mm, steps in ms

# Functions that study.toml uses.


def zero_between(rows, column):
    """The damping at which a growth vanishes, between 200 and 300 kN s/m."""
    a, b = (rows.row("damping, kN s/m", d)[column] for d in (200.0, 300.0))
    return 200.0 + 100.0 * a / (a - b)


def draw_response(axes, sections, style):
    from figures import style as look
    response = read_rows(HERE / "response.csv")
    for edge, colour in {4.0: look.GREY, 2.0: look.BLUE, 1.0: look.RED}.items():
        rows = response.where("sections", sections, "edge, mm", edge)
        axes.plot([1e3 * t for t in rows["time, s"]], [1e-6 * c for c in rows["change, N s/m"]], style, color=colour,
                  label=f"{edge:g} mm, {sections}")


# Theory.


def of_rock(t, change, settled, s):
    """The force of the rock for a motion exp(s t) of the bit."""
    h = t[1] - t[0]
    early = t <= settled + 1e-9
    total = h * np.sum(change[early] * np.exp(-s * (t[early] - 0.5 * h)))
    return s * s * (total + change[~early].mean() * math.e ** (-s * settled) / s)


def of_rods(sections, s):
    """The stiffness of continuous rods below a top that does not move."""
    k = np.sqrt(DENSITY * (s * s + MUD * s) / YOUNG)
    above = None
    for length, outer, inner in sections:
        z, th = YOUNG * math.pi / 4 * (outer**2 - inner**2) * k, np.tanh(k * length)
        above = z / th if above is None else z * (above + z * th) / (z + above * th)
    return above


def root(f, frequency):
    """The root near a frequency, by Newton's method."""
    s = complex(0.0, 2.0 * math.pi * frequency)
    for _ in range(60):
        change = f(s) * 2e-5 / (f(s + 1e-5) - f(s - 1e-5))
        s -= change
        if abs(change) < 1e-9:
            return s
    return complex(math.nan, math.nan)


def onset(dampings, growths):
    """The damping at which the line through the growths crosses zero, N s/m."""
    slope, constant = np.polyfit(dampings, growths, 1)
    return -constant / slope


def growth(t, motion, frequency, first):
    """Growth (1/s) and frequency (Hz) by the slopes of the logarithm of the amplitude over whole periods."""
    period = 1.0 / frequency
    starts = np.arange(first, t[-1] - period, period)
    amplitudes = []
    for begin in starts:
        m = (t >= begin) & (t < begin + period)
        amplitudes.append(np.mean((motion[m] - motion[m].mean()) * np.exp(-2j * math.pi * frequency * t[m])))
    slope = [np.polyfit(starts, part, 1)[0] for part in (np.log(np.abs(amplitudes)), np.unwrap(np.angle(amplitudes)))]
    return slope[0], frequency + slope[1] / (2.0 * math.pi)


# Runs.


def write_flat_bit(m):
    """Four blades with a flat face and a rounded gage, so that no face is covered."""
    rows = ["bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,side_rake_deg"]
    profile = [(6, 0, 0), (17, 0, 0), (28, 0, 0), (39, 0, 0), (47, 2.5, 35), (52, 7, 65)]
    for blade in range(4):
        rows += [f"four,{len(rows) + i},{blade + 1},nose,16,{r},{90 * blade},{h},{angle},15,0" for i, (r, h, angle) in enumerate(profile)]
    m.file("four.csv", "\n".join(rows) + "\n")
    m.file("four.toml", 'name = "four"\ntable = "four.csv"\ngage_diameter = "112 mm"\n[cutters]\nchamfer = "0 mm"\nlength = "6 mm"\n')


def run_of(m, bit, rock, motion, step, sections, more="", duration=None):
    """A run of the flat bit, or of bit B under the law of string-drill-bit-b."""
    forces = ('law = "detournay"\neps = "60 MPa"\nzeta = 0.6\n' if str(bit) == "four.toml" else
              'law = "hanson-hansen"\nA1 = 1.0\nA2 = 0.3\nA3 = "18 deg"\nA4 = 0.5\nA5 = 1.0\nA6 = 0.3\n')
    text = (f'[bit]\nfile = "{bit}"\n[rock]\n{rock}material = "mancos-shale"\npressure = "3000 psi"\n[motion]\n{motion}'
            f'[time]\nstep = "{step} ms"\n[measure]\nsection_at_face = "{sections}"\n[forces]\n{forces}{more}')
    return m.run(m.case(text), {"time.duration": duration} if duration else {})


def legs(speed, *parts):
    """A prescribed motion with a sequence of (seconds, rate)."""
    return 'kind = "legs"\n' + "".join(
        f'[[motion.legs]]\nduration = {d}\nrotary_speed = "{speed} rpm"\nvelocity = [0, 0, {v}]\n' for d, v in parts)


def response(m, edge, step, sections):
    """Seconds after a change of the rate by a fifth, the change of weight over that change (N s/m), and the loads of a turn at the
    previous rate. The rock of that turn is stored in bottom.ply."""
    turn, rate, speed = FLAT["turn"], FLAT["rate"], FLAT["speed"]
    rock, change, after = f'edge_length = "{edge} mm"\nwall = "40 mm"\n', 0.2 * rate, 2.4 * turn
    steady, faster = (run_of(m, "four.toml", rock, legs(speed, (turn, rate), (after, v)), step, sections).history.weight_on_bit
                      for v in (rate, rate + change))
    run = run_of(m, "four.toml", rock, legs(speed, (turn, rate)), step, sections)
    shutil.copy(run.folder / "rock_final.ply", m.temporary / "bottom.ply")
    before = run.history
    end = float(before.time[-1])
    late = before.time > end - 0.5 * turn
    t = steady.time.values - end
    here = t > 1e-9
    return t[here], (faster.values - steady.values)[here] / change, (float(before.weight_on_bit[late].mean()), float(before.torque_on_bit[late].mean()))


def string(damping):
    flywheel = 1e6  # kg m2, keeps the rotary speed
    text = (f'[string]\nmodel = "chain"\nelement_length = "10 m"\nmass = {FLAT["mass"]}\ntorsional_inertia = {flywheel}\n'
            f'bending_inertia = {flywheel}\nlateral_stiffness = 5e8\nlateral_damping = 2e6\nbending_stiffness = 1e9\n'
            f'bending_damping = 1e7\naxial_damping = {damping}\n'
            f'dampers_to = "space"\nattachment_height = 0\n[string.friction]\naxial_damping = {MUD}\n')
    return text + "".join(f"[[string.sections]]\nlength = {a}\nouter_diameter = {b}\ninner_diameter = {c}\n" for a, b, c in FLAT["sections"])


def drilled(m, edge, step, sections, loads, damping):
    """Growth and frequency of a run that starts on the bottom of the prescribed motion, and the swing of its weight after two
    seconds: the standard deviation over the mean."""
    kick = 0.6  # share of the weight that the string carries in excess at the start
    rock = f'shape = "file"\nfile = "bottom.ply"\nunit = "1 m"\nedge_length = "{edge} mm"\n'
    motion = (f'kind = "drilling"\nstart = [0, 0, {FLAT["rate"] * FLAT["turn"]}]\nrotary_speed = "{FLAT["speed"]} rpm"\n'
              f'rate_of_penetration = {FLAT["rate"]}\nweight_at_start = {(1 + kick) * loads[0]}\ntorque_at_start = {loads[1]}\n')
    found = run_of(m, "four.toml", rock, motion + string(damping), step, sections, duration=4.0).history
    t = found.time.values
    late = found.weight_on_bit.values[t > 2.0]
    return *growth(t, found.position_z.values - FLAT["rate"] * t, FLAT["frequency"], 0.8), late.std() / late.mean()


def flat_row(m, edge, step, sections):
    t, change, loads = response(m, edge, step, sections)
    # The response jumps, rises in proportion to time, and stays.
    delay = FLAT["turn"] / 4
    stiffness, jump = np.polyfit(t[t < 0.75 * delay], change[t < 0.75 * delay], 1)
    seen = (change[t > 1.3 * delay].mean() - jump) / stiffness

    def theory(damping):
        return root(lambda s: FLAT["mass"] * s * s + damping * s + of_rods(FLAT["sections"], s) + of_rock(t, change, FLAT["settled"], s),
                    FLAT["frequency"])

    def runs(damping):
        return drilled(m, edge, step, sections, loads, damping)

    dampings = FLAT["dampings"]
    roots = [theory(d) for d in dampings]
    row = {"edge, mm": edge, "step, ms": step, "jump, kN s/m": 1e-3 * jump, "stiffness, MN/m": 1e-6 * stiffness, "delay, ms": 1e3 * seen,
           "growth undamped by theory, 1/s": theory(0.0).real, "swing of an undamped run": runs(0.0)[2],
           "onset by theory, kN s/m": 1e-3 * onset(dampings, [s.real for s in roots])}
    if sections == "extrapolated":
        found = [runs(d) for d in dampings]
        row |= {"onset of runs, kN s/m": 1e-3 * onset(dampings, [g[0] for g in found]),
                "frequency by theory, Hz": roots[0].imag / (2 * math.pi), "frequency of the run, Hz": found[0][1]}
    return row, [r for r in zip(t, change) if r[0] < 0.25]


def mean_response(m, edge, bodies):
    """The response of bit B, whose weight is noisy: the mean over four times of the change and both signs."""
    rate, rock = BIT_B["rate"], f'edge_length = "{edge} mm"\nwall = "40 mm"\n'

    def weight(before, after):
        motion = legs(BIT_B["speed"], (before, rate), (1.2, after))
        found = run_of(m, ROOT / "cases/bits/bit-b.toml", rock, motion, 1.0, "extrapolated", bodies)
        return found.history.weight_on_bit.values[round(1000 * before):]

    changes = []
    for before in (1.0, 1.125, 1.25, 1.375):
        steady = weight(before, rate)
        changes += [(weight(before, rate + change) - steady)[1:1200] / change for change in (0.2 * rate, -0.2 * rate)]
    return 1e-3 * np.arange(1, 1200), np.mean(changes, axis=0)


def bit_b_rows(m, edge, bodies):
    """Growths computed from the mean response, and those of the shipped case with other dampings."""
    t, change = mean_response(m, edge, bodies)
    text = (ROOT / "cases/string-drill-bit-b.toml").read_text(encoding="utf-8") + bodies
    case = m.case(text.replace("bits/bit-b.toml", str(ROOT / "cases/bits/bit-b.toml")))
    for damping in BIT_B["dampings"]:
        s = root(lambda s, c=damping: BIT_B["mass"] * s * s + c * s + of_rods(BIT_B["sections"], s) + of_rock(t, change, BIT_B["settled"], s),
                 BIT_B["frequency"])
        found = m.run(case, {"rock.edge_length": f"{edge} mm", "time.duration": "10 s", "string.axial_damping": damping}).history
        rate, frequency = growth(found.time.values, found.rate_of_penetration.values, BIT_B["frequency"], 2.0)
        yield {"bodies": "none" if bodies else "bear", "edge, mm": edge, "damping, kN s/m": 1e-3 * damping, "growth by theory, 1/s": s.real,
               "growth of the run, 1/s": rate, "frequency by theory, Hz": s.imag / (2 * math.pi), "frequency of the run, Hz": frequency}


def limit_of_exact_rock():
    """The response of the flat bit on exact rock. The direction of cutting tilts as the bit goes down faster: eps times the area of every
    cutter, 4 blades of depth d and width w at radius r, over the speed of the cutter around the axis. What is left of the response
    of steady drilling, which hardly depends on the edges, comes after a quarter turn."""
    widths = {6: 11.5, 17: 11.0, 28: 11.0, 39: 9.5, 47: 6.5, 52: 7.0}  # mm by radius in mm
    depth, turning, delay = FLAT["rate"] * FLAT["turn"] / 4, 2 * math.pi / FLAT["turn"], FLAT["turn"] / 4
    jump = 4 * 60e6 * depth * sum(w / r for r, w in widths.items()) / turning
    finest = read_rows(HERE / "flat.csv")[-1]
    steady = 1e3 * finest["jump, kN s/m"] + 1e3 * finest["stiffness, MN/m"] * finest["delay, ms"]
    stiffness = (steady - jump) / delay

    def theory(damping):
        return root(lambda s: FLAT["mass"] * s * s + (damping + jump) * s + of_rods(FLAT["sections"], s) +
                    stiffness * (1.0 - np.exp(-s * delay)), FLAT["frequency"])

    return {"jump, kN s/m": 1e-3 * jump, "stiffness, MN/m": 1e-6 * stiffness, "delay, ms": 1e3 * delay,
            "growth undamped by theory, 1/s": theory(0.0).real, "frequency by theory, Hz": theory(FLAT["dampings"][0]).imag / (2 * math.pi),
            "onset by theory, kN s/m": 1e-3 * onset(FLAT["dampings"], [theory(d).real for d in FLAT["dampings"]])}


def rounded(rows):
    return [{k: float(f"{v:.4g}") if isinstance(v, float) else v for k, v in r.items()} for r in rows]


def measure(m):
    """Parts for --only: flat, bit-b."""
    if m.includes("flat"):
        write_flat_bit(m)
        responses = []
        for sections, name in (("extrapolated", "flat.csv"), ("as_ahead", "as-ahead.csv")):
            rows = []
            for edge, step in LEVELS:
                row, curve = flat_row(m, edge, step, sections)
                rows.append(row)
                if step == 1.0 and edge in (4.0, 2.0, 1.0):
                    responses += [{"sections": sections, "edge, mm": edge, "time, s": float(a), "change, N s/m": float(b)} for a, b in curve[::2]]
            m.write(name, rounded(rows))
        m.write("response.csv", rounded(responses))
        m.write("limit.csv", rounded([limit_of_exact_rock()]))
    if m.includes("bit-b"):
        m.write("bit-b.csv", rounded(r for edge, bodies in itertools.product((4.2, 3.0, 2.1), (NONE, "")) for r in bit_b_rows(m, edge, bodies)))
