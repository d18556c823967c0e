"""The numbers of README.md, from the data of this study."""

import math
from pathlib import Path

from study_tools import read_csv, read_rows

HERE = Path(__file__).parent
SHEAR, FREQUENCY = 79.3e9, 0.2340  # Pa; Hz: first torsional vibration of the string
SECTIONS = ((2300.0, 0.127, 0.1086), (200.0, 0.1651, 0.0714))  # m: length, diameters
GIVEN = ["A step of 0.25 ms", "2300 m of pipe", "200 m of collars", "2900 kg m2", "4 Z", "0.234 Hz", "95 % of the inertia", "100 N m/rad", "from 15 s on",
         "75 rpm", "60 rpm", "0.1 1/s", "1 ms", "edges of 2 mm", "edges of 4 mm", "80 kN", "two levels of torque (c1", "first 28 s", "steps of 1 and 0.5 ms with edges of 4 mm, and edges of 4, 2.8 and 2 mm"]


def lumped(rpm, static, dynamic):
    """(stick, slip, peak): times in s and the largest speed in rad/s of one inertia on one spring with two levels of torque."""
    spring = 1.0 / sum(length / (SHEAR * math.pi / 32.0 * (outer**4 - inner**4)) for length, outer, inner in SECTIONS)
    natural, top = 2.0 * math.pi * FREQUENCY, rpm * math.pi / 30.0
    impedance, drop = spring / natural, static - dynamic  # k/w = sqrt(k I)
    slip = 2.0 * (math.pi - math.atan(drop / (impedance * top))) / natural
    return 2.0 * drop / (spring * top), slip, top + math.hypot(top, drop / impedance)


def stated():
    rows = read_rows(HERE / "runs.csv")
    first = {r["top"]: r for r in rows[:3]}
    second = {r["top"]: r for r in rows[3:6]}
    stiff, soft, z = (first[k] for k in ("stiff", "soft-torque", "z-torque"))
    number = lambda row, key: float(row[key])
    yield ("severity of {:.2f}, a period of {:.2f} s and the bit at rest for {:.0f} % of the time", number(stiff, "severity"), number(stiff, "period_s"),
           100.0 * number(stiff, "stuck_share"))
    yield "reaches {:.0f} rpm; the torque at the surface swings by {:.1f} kN m", number(stiff, "most_rpm"), 1e-3 * number(stiff, "surface_torque_swing_n_m")
    yield ("between {:.0f} and {:.0f} rpm, with a severity of {:.2f}, while the torque at the surface swings by {:.1f} kN m", number(soft, "least_rpm"),
           number(soft, "most_rpm"), number(soft, "severity"), 1e-3 * number(soft, "surface_torque_swing_n_m"))
    yield ("between {:.0f} and {:.0f} rpm, a severity of {:.3f}; the torque at the surface swings by {:.2f} kN m", number(z, "least_rpm"),
           number(z, "most_rpm"), number(z, "severity"), 1e-3 * number(z, "surface_torque_swing_n_m"))
    yield ("severities of {:.2f}, {:.2f} and {:.3f}", *(number(second[k], "severity") for k in ("stiff", "soft-torque", "z-torque")))
    yield "soft-torque top the bit rests for {:.0f} % of the time", 100.0 * number(second["soft-torque"], "stuck_share")
    reflection = read_csv(HERE / "reflection.csv")
    of_cycle = 1.0 / number(stiff, "period_s")
    nearest = min(range(len(reflection["frequency_hz"])), key=lambda i: abs(reflection["frequency_hz"][i] - of_cycle))
    yield "At {:.3f} Hz, the frequency of", of_cycle
    yield "{:.2f} of an incident wave and z-torque {:.2f}", reflection["soft-torque"][nearest], reflection["z-torque"][nearest]
    levels = number(stiff, "breakaway_n_m"), number(stiff, "torque_turning_n_m")
    stick, slip, peak = lumped(number(stiff, "rpm"), *levels)
    yield "{:.2f} kN m on average when the bit breaks away and {:.2f} kN m while", *(1e-3 * t for t in levels)
    yield "stick {:.2f} s and slip {:.2f} s: a period of {:.2f} s, {:.1f} % from that of the run", stick, slip, stick + slip, \
        100.0 * abs((stick + slip) / number(stiff, "period_s") - 1.0)
    yield "predicts a peak of {:.0f} rpm", peak * 30.0 / math.pi
    with_mud, without = read_rows(HERE / "simple.csv")
    yield "severity falls to {:.2f}, without any rest", number(with_mud, "severity")
    yield "sticks for {:.0f} % of the time, with a severity of {:.2f} and a period of {:.2f} s", 100.0 * number(without, "stuck_share"), \
        number(without, "severity"), number(without, "period_s")
    torque = read_csv(HERE / "torque.csv")
    yield "speeds up, from {:.1f} kN m below {:.0f} rad/s to {:.1f} kN m above {:.0f} rad/s", 1e-3 * torque["rising_n_m"][0], torque["to_rad_s"][0], \
        1e-3 * torque["rising_n_m"][-1], torque["from_rad_s"][-1]
    yield from convergence(rows, stiff)
    [cost] = read_rows(HERE / "cost.csv")
    yield "{:.0f} s of the shipped case (edges of 2 mm, steps of 1 ms, one thread) took {:.0f} s on a quiet machine: {:.2f} times", \
        cost["simulated_s"], cost["wall_s"], cost["simulated_s"] / cost["wall_s"]


def convergence(rows, shipped):
    others = [r for r in rows[6:]] + [shipped]
    for phrase, key in (("The severity is between {:.2f} and {:.2f}", "severity"), ("and the period between {:.2f} and {:.2f} s", "period_s")):
        values = [float(r[key]) for r in others]
        yield phrase, min(values), max(values)
