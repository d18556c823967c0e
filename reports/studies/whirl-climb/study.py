"""The speed at which a whirling bit climbs, compared with that of a screw with its lean: cases/drill-bit-b-whirl with strings of
decreasing bending stiffness. Also its advance over the time step."""

import numpy as np

RING_RADIUS, RING_HEIGHT = 0.10795, 0.08  # m: gage radius of bit B, wall.ring_height
FROM = 0.5  # s: by then the bit rolls
# bending stiffness in N m/rad, its damping in N m s/rad, edges in mm
STRINGS = [("3e7", "3e5", "1.5"), ("3e7", "3e5", "3"), ("1e7", "1e5", "3"), ("2e6", "2e4", "3"), ("1e6", "1e4", "3"), ("1e6", "1e3", "3"),
           ("2e5", "1e3", "3")]
SHIPPED = {"string.bending_stiffness": 3e7, "string.bending_damping": 3e5, "motion.weight_on_bit": 10e3, "wall.slip_speed": 60e-3}
CLIMBING = {"string.bending_stiffness": 1e7, "string.bending_damping": 1e5, "motion.weight_on_bit": 5e3, "wall.slip_speed": 1e-3}
# the case of a row of steps.csv, its settings, edges in mm
CASES = [("shipped", SHIPPED, "1.5"), ("climbing", CLIMBING, "3")]
STEPS = [1, 0.5, 0.25, 0.125, 0.0625]  # ms


def drill(m, settings, edges):
    return m.run("cases/drill-bit-b-whirl.toml", {**settings, "rock.edge_length": f"{edges} mm"})


def axes_of(history):
    """The bit's axis in space at every row: R e_z of the rotation vector."""
    vector = np.stack([history[f"rotation_vector_{x}"].values for x in "xyz"], 1)
    angle = np.linalg.norm(vector, axis=1, keepdims=True)
    n = vector / np.where(angle == 0.0, 1.0, angle)
    cosine, z = np.cos(angle), np.array([0.0, 0.0, 1.0])
    return cosine * z + np.sin(angle) * np.cross(n, z) + (1.0 - cosine) * n[:, 2:] * n


def climb_of(history):
    """Means since FROM: the climb, lean times travel of the touching point over the wall, and the difference: slip."""
    time, axis = history.time.values, axes_of(history)
    centre = np.stack([history[f"position_{x}"].values for x in "xyz"], 1) - RING_HEIGHT * axis
    e = np.hypot(centre[:, 0], centre[:, 1])
    around = np.gradient(np.unwrap(np.arctan2(centre[:, 1], centre[:, 0])), time)
    tangent = np.stack([-centre[:, 1], centre[:, 0]], 1) / np.maximum(e, 1e-12)[:, None]
    lean = np.sum(axis[:, :2] * tangent, 1)
    travel = around * (RING_RADIUS + e)
    late = time > FROM
    mean = lambda values, digits, scale=1.0: f"{scale * values[late].mean():.{digits}f}"
    return {"climb, mm/s": mean(-np.gradient(centre[:, 2], time), 2, 1e3), "lean times travel, mm/s": mean(lean * travel, 2, 1e3),
            "centre's circle, mm": mean(e, 2, 1e3), "orbit, Hz": f"{around[late].mean() / (2.0 * np.pi):.1f}",
            "centre's speed, m/s": mean(np.abs(around * e), 2), "travel, m/s": mean(travel, 1), "lean, mrad": mean(lean, 3, 1e3)}


def advance_of(history):
    """Mean advance since FROM, m/s, from the first and the last position."""
    z, first = history.position_z.values, int(np.argmin(np.abs(history.time.values - FROM)))
    return (z[-1] - z[first]) / (history.time.values[-1] - history.time.values[first])


def rows_of_strings(m):
    for stiffness, damping, edges in STRINGS:
        run = drill(m, {"string.bending_stiffness": float(stiffness), "string.bending_damping": float(damping)}, edges)
        yield {"bending stiffness, N m/rad": stiffness, "damping, N m s/rad": damping, "edges, mm": edges, **climb_of(run.history)}


def rows_of_steps(m):
    for name, settings, edges in CASES:
        for step in STEPS:
            run = drill(m, {**settings, "time.step": step * 1e-3}, edges)
            yield {"case": name, "edges, mm": edges, "step, ms": step, "advance, mm/s": f"{1e3 * advance_of(run.history):.3f}",
                   "rop_mean, mm/s": f"{1e3 * run.summary['rop_mean_m_per_s']:.3f}", "weight, kN": f"{1e-3 * run.summary['wob_mean_n']:.3f}"}


def measure(m):
    m.write("climb.csv", rows_of_strings(m))
    m.write("steps.csv", rows_of_steps(m))
