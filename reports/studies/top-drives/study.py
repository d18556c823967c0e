"""Stick-slip of cases/string-stick-slip.toml under three top drives, and its convergence in time step and edge length."""

import json
import math

import numpy as np
from study import read_case

CASE = "cases/string-stick-slip.toml"
INERTIA, FREQUENCY = 2900.0, 0.234  # kg m2 of a top drive; Hz, the string's first torsional vibration
FACTOR, COMPENSATION, SMALL_INTEGRAL = 4.0, 0.95, 100.0  # soft torque; z-torque
OUTER, INNER, SHEAR, DENSITY = 0.127, 0.1086, 79.3e9, 7850.0  # m, Pa, kg/m3: the pipe
TOPS = {
    "stiff": {},
    "soft-torque": {"string.top.torsion": "soft-torque", "string.top.inertia": f"{INERTIA} kg m2",
                    "string.top.impedance_factor": FACTOR, "string.top.tuned_frequency": f"{FREQUENCY} Hz"},
    "z-torque": {"string.top.torsion": "z-torque", "string.top.inertia": f"{INERTIA} kg m2",
                 "string.top.compensation": COMPENSATION, "string.top.integral": f"{SMALL_INTEGRAL} N m/rad"},
}
SPEED, DURATION = 75, 40.0  # rpm, s
# top, rpm, step in ms, edges in mm, duration in s; the second speed is run with coarse edges, the last three for convergence
PLAN = [(top, rpm, 1.0, edge, DURATION) for rpm, edge in ((SPEED, 2.0), (60, 4.0)) for top in TOPS] + \
    [("stiff", SPEED, step, edge, 28.0) for step, edge in ((1.0, 4.0), (0.5, 4.0), (1.0, 2.8))]
SETTLED = 15.0  # s: the transient of the start ends before
MUD = (0.1, 0.0)  # 1/s: of the runs, and none
BIT = (38.49, 0.13518)  # kg, kg m2: bit B
RANGES = (0.2, 1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 21.0)  # rad/s
ROW = 0.05  # s between rows of traces.csv

# Functions that study.toml uses.

SHEAR_OF_STRING, FIRST = 79.3e9, 0.2340  # Pa; Hz: first torsional vibration of the string
SECTIONS = ((2300.0, 0.127, 0.1086), (200.0, 0.1651, 0.0714))  # m: length, diameters


def lumped(rpm, static, dynamic):
    """(stick, slip, peak): times in s and the largest speed in rad/s of one inertia on one spring with two levels of torque."""
    spring = 1.0 / sum(length / (SHEAR_OF_STRING * math.pi / 32.0 * (outer**4 - inner**4)) for length, outer, inner in SECTIONS)
    natural, top = 2.0 * math.pi * FIRST, rpm * math.pi / 30.0
    impedance, drop = spring / natural, static - dynamic  # k/w = sqrt(k I)
    slip = 2.0 * (math.pi - math.atan(drop / (impedance * top))) / natural
    return 2.0 * drop / (spring * top), slip, top + math.hypot(top, drop / impedance)


def mark_stick_slip(axes, frequency):
    from figures import style
    axes.annotate("stick-slip under\nthe stiff top", (frequency, 0.45), xytext=(4, 0), textcoords="offset points", color=style.GREY, fontsize=8)


# Measurement.


def late(history, *names):
    chosen = history["time"].values >= SETTLED
    return [history[name].values[chosen] for name in names]


def period(time, speed):
    """Mean time between rises from below 0.7 to above 1.3 times the mean speed. Blank if there are less than two."""
    low, rises = False, []
    for t, share in zip(time, speed / speed.mean()):
        if low and share > 1.3:
            rises.append(t)
        low = share < 0.7 or (low and share <= 1.3)
    return round(float(np.diff(rises).mean()), 4) if len(rises) > 1 else ""


def row(history, top, rpm, step, edge):
    """Values of a run after its transient."""
    time, speed, surface, torque, weight = late(history, "time", "rotary_speed", "surface_torque", "torque_on_bit", "weight_on_bit")
    mean = speed.mean()
    stuck = speed < 0.05 * mean
    moves = np.flatnonzero(stuck[:-1] & ~stuck[1:])
    breakaway = [torque[max(i - 100, 0):i + 1].max() for i in moves if stuck[max(i - 50, 0):i].all()]
    return {"top": top, "rpm": rpm, "step_ms": step, "edge_mm": edge, "severity": round((speed.max() - speed.min()) / (2.0 * mean), 4),
            "stuck_share": round(float(stuck.mean()), 4), "period_s": period(time, speed),
            "least_rpm": round(speed.min() * 30.0 / math.pi, 2), "most_rpm": round(speed.max() * 30.0 / math.pi, 2),
            "surface_torque_swing_n_m": round(float(np.ptp(surface)), 1), "surface_torque_mean_n_m": round(float(surface.mean()), 1),
            "torque_mean_n_m": round(float(torque.mean()), 1), "torque_turning_n_m": round(float(torque[speed > mean].mean()), 1),
            "breakaway_n_m": round(float(np.mean(breakaway)), 1) if breakaway else "", "weight_swing_n": round(float(np.ptp(weight)), 1)}


def torque_over_speed(history):
    """Mean torque on the bit in ranges of its speed, separately for rising and falling speed."""
    speed, torque = late(history, "rotary_speed", "torque_on_bit")
    rises = np.gradient(speed) > 0.0
    for low, high in zip(RANGES, RANGES[1:]):
        within = (speed >= low) & (speed < high)
        yield {"from_rad_s": low, "to_rad_s": high, "rising_n_m": round(float(torque[within & rises].mean()), 1),
               "falling_n_m": round(float(torque[within & ~rises].mean()), 1)}


def simple(m, levels, mud):
    """The same string on a bit of two levels of torque, N m, released from rest; with a damping of the mud, 1/s."""
    string = read_case(CASE)["string"]
    plain = lambda table: "\n".join(f"{key} = {json.dumps(value)}" for key, value in table.items())
    text = ["[string]", 'model = "chain"', 'start = "rest"', f"mass = {BIT[0]}", f"torsional_inertia = {BIT[1]}"]
    text += ["[[string.sections]]\n" + plain(section) for section in string["sections"]]
    text += ["[string.friction]", plain(string["friction"]), f"torsional_damping = {mud}"]
    text += ["[string.bit]", 'law = "two-level"', f"static = {levels[0]}", f"dynamic = {levels[1]}"]
    text += ["[motion]", f'rotary_speed = "{SPEED} rpm"', f"torque_at_start = {levels[0] - 5.0}"]
    text += ["[time]", 'step = "1.0 ms"', f'duration = "{DURATION} s"']
    time, speed, surface = late(m.run(m.case("\n".join(text)), command="string").history, "time", "speed", "surface_torque")
    stuck = speed < 0.05 * speed.mean()
    return {"static_n_m": levels[0], "dynamic_n_m": levels[1], "mud_per_s": mud,
            "severity": round((speed.max() - speed.min()) / (2.0 * speed.mean()), 4), "stuck_share": round(float(stuck.mean()), 4),
            "period_s": period(time, speed), "most_rpm": round(speed.max() * 30.0 / math.pi, 2),
            "surface_torque_swing_n_m": round(float(np.ptp(surface)), 1)}


def reflection_of(kind, frequency):
    """Magnitude of the reflection (Z - Zt)/(Z + Zt) at the top of waves in the pipe."""
    z = math.pi / 32.0 * (OUTER**4 - INNER**4) * math.sqrt(SHEAR * DENSITY)
    s = 2j * math.pi * frequency
    if kind == "stiff":
        return 1.0
    if kind == "soft-torque":
        zt = INERTIA * s + FACTOR * z + INERTIA * (2.0 * math.pi * FREQUENCY) ** 2 / s
    else:
        zt = (1.0 - COMPENSATION) * INERTIA * s + z + SMALL_INTEGRAL / s
    return abs((z - zt) / (z + zt))


def traces_of(histories):
    """Rows of ROW seconds of the runs at the first speed: speeds in rpm, torque at the surface in kN m."""
    time = np.arange(ROW, DURATION + 0.5 * ROW, ROW)
    columns = {"time_s": np.round(time, 3)}
    for top, data in histories.items():
        for name, key, scale in (("bit_rpm", "rotary_speed", 30.0 / math.pi), ("top_rpm", "top_speed", 30.0 / math.pi),
                                 ("surface_torque_kn_m", "surface_torque", 1e-3), ("torque_kn_m", "torque_on_bit", 1e-3)):
            columns[f"{top}_{name}"] = np.round(np.interp(time, data["time"].values, scale * data[key].values), 3)
    return [dict(zip(columns, map(float, values))) for values in zip(*columns.values())]


def measure(m):
    rows, shown = [], {}
    for top, rpm, step, edge, duration in PLAN:
        settings = {"motion.rotary_speed": f"{rpm} rpm", "time.step": f"{step} ms", "time.duration": f"{duration} s", "rock.edge_length": f"{edge} mm"}
        history = m.run(CASE, TOPS[top] | settings).history
        rows.append(row(history, top, rpm, step, edge))
        shown.setdefault(top, history)
    m.write("runs.csv", rows)
    m.write("torque.csv", torque_over_speed(shown["stiff"]))
    levels = (rows[0]["breakaway_n_m"], rows[0]["torque_turning_n_m"])
    m.write("simple.csv", (simple(m, levels, mud) for mud in MUD))
    m.write("traces.csv", traces_of(shown))
    frequencies = sorted({round(1.0 / rows[0]["period_s"], 4), FREQUENCY} | {round(float(f), 4) for f in np.geomspace(0.05, 3.0, 121)})
    m.write("reflection.csv", ({"frequency_hz": f} | {kind: round(reflection_of(kind, f), 5) for kind in TOPS} for f in frequencies))
