"""Forces of parts that press on rock over the edge length.

Single parts are pressed into flat rock and slide in it, against the exact area of their own facets. Bit R drills at a prescribed
rate. Pads with Coulomb friction stick and slip, against the closed form of that cycle.
"""

import itertools
import math

import numpy as np
from study_tools import ROOT

# Single contacts.

EDGES = (1.6, 1.13, 0.8, 0.57, 0.4)  # mm
STRESS = 100e6  # Pa: ratio 1 of the law, a rock of 100 MPa
PRESS, SLIDE = 100.0, 100.0  # mm/s
FROM = 0.06  # s after the start of the slide; by then a part has left the place where it was pressed
CONTACT_CASE = """
[bit]
file = "part.toml"
[rock]
shape = "flat"
radius = "30 mm"
wall = "2 mm"
edge_length = "{edge} mm"
[rock.material]
name = "synthetic"
unconfined_strength = "100 MPa"
friction_angle = "0 deg"
[motion]
kind = "legs"
start = ["-8 mm", "0.13 mm", "0 mm"]
[[motion.legs]]
duration = "{press:.9g} s"
velocity = ["0 mm/s", "0 mm/s", "{down} mm/s"]
[[motion.legs]]
duration = "0.14 s"
velocity = ["{slide} mm/s", "0 mm/s", "{sinks} mm/s"]
[time]
step = "0.5 ms"
[forces]
law = "{law}"
mu = 0
slip_speed = "0.001 mm/s"
{strength}
[output]
history_every = 1
"""


def prism(outline, length):
    """The corners of a prism with the outline (x, z) along y."""
    return np.array([(x, y, z) for y in (-length / 2, length / 2) for x, z in outline])


def box(x, y, z):
    return prism([(-x / 2, 0), (x / 2, 0), (x / 2, -z), (-x / 2, -z)], y)


def turned(corners, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return corners @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def tilted(corners, degrees):
    """The corners leaned forward, moved so that the lowest is at z = 0."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    corners = corners @ np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    return corners - [0, 0, corners[:, 2].max()]


def ball(radius=6.0, rings=40):
    points = [(0, 0, 0), (0, 0, -2 * radius)]
    for i, k in itertools.product(range(1, rings), range(2 * rings)):
        turn, angle = math.pi * i / rings, math.pi * (k + 0.5 * (i % 2)) / rings
        points.append((radius * math.sin(turn) * math.cos(angle), radius * math.sin(turn) * math.sin(angle), radius * math.cos(turn) - radius))
    return np.array(points)


def ring(radius, z, facets):
    turn = 2 * math.pi * np.arange(facets) / facets
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full(facets, z)], axis=1)


WEDGE = prism([(0, 0), (7, -4), (-7, -4)], 10)  # sides at 60 degrees to the axis
TOOTH = prism([(1, 0), (-1, 0), (-4.7, -8), (4.7, -8)], 8)  # flanks at 25 degrees, a crest of 2 mm
# name: corners (mm, z down, lowest at 0), depth (mm), sinking speed while it slides (mm/s), law
CONTACTS = {
    "ball": (ball(), 2.0, 0.0, "indentation"),
    "cone": (np.concatenate([[(0, 0, 0)], ring(4.0 * math.tan(math.radians(60.0)), -4.0, 48)]), 2.0, 0.0, "indentation"),
    "wedge": (WEDGE, 2.0, 0.0, "indentation"),
    "wedge yawed 37 deg": (turned(WEDGE, 37), 2.0, 0.0, "indentation"),
    "milled tooth yawed 20 deg": (turned(TOOTH, 20), 2.0, 8.0, "indentation"),
    "flat punch": (box(9, 6, 8), 1.5, 8.0, "indentation"),
    "flat punch yawed 23 deg": (turned(box(9, 6, 8), 23), 1.5, 8.0, "indentation"),
    "block tilted 12 deg": (tilted(turned(box(9, 6, 8), 23), 12), 1.5, 8.0, "indentation"),
    "wear flat": (np.concatenate([ring(4.0, z, 64) for z in (0.0, -8.0)]), 0.5, 8.0, "friction"),
    "pad": (box(15, 10, 8), 0.3, 8.0, "friction"),
}


def facets(corners):
    """Triangles of the convex hull, counter-clockwise seen from outside."""
    from scipy.spatial import ConvexHull
    hull = ConvexHull(corners)
    return np.array([t if np.dot(np.cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]), plane[:3]) > 0 else t[::-1]
                     for t, plane in zip(hull.simplices, hull.equations)])


def exact(corners, triangles, depth, velocity):
    """Area vector (mm2, onto the part) of the facets that move into the rock, below its plane."""
    total = np.zeros(3)
    for t in triangles:
        x = corners[t] + [0, 0, depth]
        normal = np.cross(x[1] - x[0], x[2] - x[0])
        if normal @ velocity < -1e-9 * np.linalg.norm(normal) * np.linalg.norm(velocity):
            continue
        below = []
        for a, b in zip(x, np.roll(x, -1, axis=0)):
            if a[2] >= 0:
                below.append(a)
            if (a[2] >= 0) != (b[2] >= 0):
                below.append(a + a[2] / (a[2] - b[2]) * (b - a))
        for b, c in zip(below[1:-1], below[2:]):
            total -= 0.5 * np.cross(b - below[0], c - below[0])
    return total


def contact_history(m, corners, triangles, depth, sinks, law, edge):
    m.file("part.off", f"OFF\n{len(corners)} {len(triangles)} 0\n" + "".join(f"{x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in corners)
           + "".join(f"3 {a} {b} {c}\n" for a, b, c in triangles))
    m.file("part.toml", f'name = "part"\nunit_check = "off"\n[[parts]]\nname = "part"\nkind = "{"tooth" if law == "indentation" else "gage-pad"}"\n'
           'file = "part.off"\nunit = "1 mm"\nupdate_direction = [0, 0, 1]\n')
    strength = "ratio = 1\n" if law == "indentation" else 'stress = "100 MPa"\nfull_angle = 0\n'
    return m.run(m.case(CONTACT_CASE.format(edge=edge, press=depth / PRESS, down=PRESS, slide=SLIDE, sinks=sinks, law=law, strength=strength))).history


def contact_row(m, name, edge):
    """Forces over exact ones at one edge length: at the end of the press, and on average over the slide."""
    corners, depth, sinks, law = CONTACTS[name]
    triangles = facets(corners)
    history = contact_history(m, corners, triangles, depth, sinks, law, edge)
    time, weight, drag = history.time.values, history.weight_on_bit.values, -history.force_x.values
    pressed = int(np.searchsorted(time, depth / PRESS + 1e-9)) - 1
    down = STRESS * 1e-6 * -exact(corners, triangles, PRESS * time[pressed], np.array([0, 0, 1.0]))
    late = np.flatnonzero(time > depth / PRESS + FROM)
    depths = depth + sinks * (time[late] - depth / PRESS) if sinks else [depth]
    slid = STRESS * 1e-6 * -np.array([exact(corners, triangles, z, np.array([SLIDE, 0, sinks])) for z in depths])
    slid = np.broadcast_to(slid, (len(late), 3))
    return {"contact": name, "edges, mm": edge, "pressed weight": weight[pressed] / down[2],
            "weight": weight[late].mean() / slid[:, 2].mean(), "drag": drag[late].mean() / slid[:, 0].mean(),
            "scatter of weight": np.std(weight[late] / slid[:, 2])}


def orders_of(rows):
    """The order of each ratio's distance from 1 by least squares over the levels, and the ratio at the finest level."""
    edges = np.log([r["edges, mm"] for r in rows])
    found = {"contact": rows[0]["contact"]}
    for column in ("pressed weight", "weight", "drag"):
        errors = np.abs([r[column] - 1.0 for r in rows])
        found[column + ": order"] = np.polyfit(edges, np.log(np.maximum(errors, 1e-12)), 1)[0]
        found[column + ": at 0.4 mm"] = rows[-1][column]
    return found


# Bit R.

LEVELS = ((2.8, 1.0), (2.0, 1.0), (1.4, 1.0), (1.0, 1.0), (2.0, 0.5), (1.4, 0.5))  # mm, ms
BIT_R = f"""
[bit]
file = "{ROOT}/cases/bits/bit-r.toml"
[rock]
shape = "conforming"
wall = "60 mm"
material = "mancos-shale"
pressure = "3000 psi"
[motion]
kind = "steady"
rotary_speed = "90 rpm"
rate_of_penetration = "8 m/h"
cone_speeds = "rolling"
[time]
revolutions = 1.5
[forces]
law = "indentation"
"""


def bit_row(m, edge, step):
    run = m.run(m.case(BIT_R), {"rock.edge_length": f"{edge} mm", "time.step": f"{step} ms"})
    return {"edges, mm": edge, "step, ms": step, "weight, kN": 1e-3 * run.mean("weight_on_bit", 2 / 3), "torque, N m": run.mean("torque_on_bit", 2 / 3)}


# Four pads at 80 mm under 100 kN on a torsional pendulum; friction falls from 0.5 to 0.25 over a weakening speed.

INERTIA, STIFFNESS, WEIGHT, ARM, MU, WEAKENING, SPEED = 288.6, 611.9, 1e5, 0.08, 0.5, 0.5, 2 * math.pi
STUCK = 1e-4  # of the rotary speed
CYCLE = """
[bit]
file = "pads.toml"
[rock]
shape = "flat"
radius = "100 mm"
edge_length = "3 mm"
wall = "5 mm"
[rock.material]
unconfined_strength = "1000 MPa"
friction_angle = "30 deg"
[motion]
kind = "drilling"
rotary_speed = "60 rpm"
rate_of_penetration = "0 m/h"
weight_at_start = "100 kN"
torque_at_start = "6000 N m"
[string]
mass = "1e5 kg"
gravity = 0
torsional_inertia = "288.6 kg m2"
bending_inertia = "288.6 kg m2"
attachment_height = 0
lateral_stiffness = "1e8 N/m"
bending_stiffness = "1e8 N m/rad"
lateral_damping = "1e5 N s/m"
axial_stiffness = "1e10 N/m"
axial_damping = "1e5 N s/m"
bending_damping = "1e5 N m s/rad"
torsional_stiffness = "611.9 N m/rad"
[time]
duration = "13.5 s"
[forces]
law = "friction"
stress = "200 MPa"
cap = 100
mu = 0.5
weakening = 0.5
full_angle = 0
[output]
history_every = 1
"""
CORNERS = [(x, y, z) for z in (-20, 0) for x, y in ((70, -10), (90, -10), (90, 10), (70, 10))]
QUADS = ("3 2 1 0", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7")


def switches(time, speed):
    """Times at which the bit sticks, and at which it slips again."""
    stuck = np.abs(speed) < STUCK * SPEED
    change = np.flatnonzero(np.diff(stuck.astype(int))) + 1
    return [t for t, i in zip(time[change], change) if stuck[i]], [t for t, i in zip(time[change], change) if not stuck[i]]


def cycle_of(m, fall, step):
    """The second slip and the stick after it, with the history of the cycle."""
    m.file("pad.off", "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in CORNERS) + "".join(f"4 {quad}\n" for quad in QUADS))
    m.file("pads.toml", 'name = "pads"\n' + "".join(
        f'[[parts]]\nname = "pad-{i}"\nkind = "gage-pad"\nfile = "pad.off"\nunit = "1 mm"\n'
        f'rotation_vector = [0, 0, "{90 * i} deg"]\nupdate_direction = [0, 0, 1]\n' for i in range(4)))
    run = m.run(m.case(CYCLE), {"time.step": f"{step} ms", "forces.weakening_speed": f"{fall} mm/s"})
    time, speed, weight = run.history.time.values, run.history.rotary_speed.values, run.history.weight_on_bit.values[1:]
    sticks, slips = switches(time, speed)
    row = {"weakening speed, mm/s": fall, "step, ms": step, "stick, s": slips[1] - sticks[1], "slip, s": sticks[1] - slips[0],
           "period, s": sticks[2] - sticks[1], "peak over mean": speed[time > slips[0]].max() / SPEED,
           "least weight, kN": 1e-3 * weight.min(), "most weight, kN": 1e-3 * weight.max(), "unsettled": run.summary["counters"]["implicit_forces"]["unsettled"]}
    chosen = (time > slips[0] - 0.2) & (time < slips[1] + 0.2)
    return row, time[chosen] - slips[0], speed[chosen] / SPEED


def integrated(fall):
    """One rotational degree of freedom with the same friction law, by an adaptive method: a cycle from breakaway to breakaway."""
    from scipy.integrate import solve_ivp
    slide = 1e-3 * fall

    def rates(_, y):
        friction = WEIGHT * ARM * MU * (1 - WEAKENING * (1 - math.exp(-abs(y[1]) * ARM / slide)))
        return [SPEED - y[1], (STIFFNESS * y[0] - friction) / INERTIA]

    def stops(_, y):
        return y[1]

    def threshold(_, y):
        return y[1] - STUCK * SPEED

    stops.terminal, stops.direction = True, -1
    start = WEIGHT * ARM * MU / STIFFNESS
    solved = solve_ivp(rates, (0, 20), [start, 1e-12], events=[stops, threshold], rtol=1e-10, atol=1e-13, method="LSODA", max_step=5e-3)
    end, twist = solved.t_events[0][0], solved.y_events[0][0][0]
    up, down = solved.t_events[1][:2]
    rest = (start - twist) / SPEED
    return {"stick, s": rest + up + end - down, "slip, s": down - up, "period, s": end + rest, "peak over mean": solved.y[1].max() / SPEED}


def closed_form():
    """The closed form for friction that falls at once, the limit of a weakening speed of 0."""
    a = WEIGHT * ARM * MU * WEAKENING / STIFFNESS
    frequency = math.sqrt(STIFFNESS / INERTIA)
    stick, slip = 2 * a / SPEED, 2 / frequency * (math.pi - math.atan(a * frequency / SPEED))
    return {"stick, s": stick, "slip, s": slip, "period, s": stick + slip, "peak over mean": 1 + math.hypot(1, a * frequency / SPEED)}


def closed_speed(time, closed):
    """Speed over mean for friction that falls at once, with breakaway at time 0, from the row of cycle.csv."""
    slip, period, deviation = float(closed["slip, s"]), float(closed["period, s"]), float(closed["peak over mean"]) - 1.0
    time = np.where(time > 0.0, time % period, time)
    wave = 1.0 + deviation * np.cos(1.4561 * time - np.arccos(-1.0 / deviation))  # rad/s: sqrt(611.9/288.6)
    return np.where((time > 0) & (time < slip), wave, 0.0)


def cycles(m):
    rows = []
    for fall in (1.0, 0.05):
        for step in (1.0, 0.5, 0.25):
            row, time, speed = cycle_of(m, fall, step)
            rows.append({"from": "TDBD", **row})
            if (fall, step) == (0.05, 0.5):
                m.write("cycle-trace.csv", written({"time, s": t, "speed over mean": w} for t, w in zip(time[::20], speed[::20])))
        rows.append({"from": "one freedom, adaptive", "weakening speed, mm/s": fall, **integrated(fall)})
    return rows + [{"from": "closed form", "weakening speed, mm/s": 0.0, **closed_form()}]


def written(rows):
    """Results are written with four digits, settings unchanged."""
    form = {True: "g", False: ".4f"}
    return [{k: format(v, form[k.startswith(("edges", "step", "weakening"))]) if isinstance(v, float) else v for k, v in row.items()} for row in rows]


def measure(m):
    """Parts for --only: contacts, cycle, bit-r."""
    if m.includes("contacts"):
        rows = [contact_row(m, name, edge) for name in CONTACTS for edge in EDGES]
        m.write("contacts.csv", written(rows))
        m.write("orders.csv", written(orders_of(rows[i:i + len(EDGES)]) for i in range(0, len(rows), len(EDGES))))
    if m.includes("cycle"):
        m.write("cycle.csv", written(cycles(m)))
    if m.includes("bit-r"):
        m.write("bit-r.csv", written(bit_row(m, *level) for level in LEVELS))
