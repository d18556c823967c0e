"""Speeds of the cones of bit R over the memory of their contacts and the time step."""

import numpy as np

CASE = "cases/bit-r-rolling.toml"


def speeds_of(m, memory, step):
    """Speeds of cone 1 over the bit's in each step of the second revolution; memory and step in ms."""
    history = m.run(CASE, {"motion.cone_memory": f"{memory} ms", "time.step": f"{step} ms", "time.revolutions": 2}).history
    turned, cone = history["rotation_angle"].values, history["cone_angle"].values[:, 0]
    return np.abs(np.diff(cone) / np.diff(turned))[turned[1:] > 2.0 * np.pi]


def rows_of_memories(m):
    for memory in (0, 10, 32, 100):
        for step in (4, 2, 1):
            found = speeds_of(m, memory, step)
            yield {"memory, ms": memory, "step, ms": step, "mean speed": f"{found.mean():.4f}", "standard deviation": f"{found.std():.4f}",
                   "largest change in a step": f"{np.abs(np.diff(found)).max():.4f}"}


def measure(m):
    m.write("speeds.csv", rows_of_memories(m))
    cones = m.run(CASE, {"time.revolutions": 50}).summary["cones"]
    columns = {"pure rolling of the gage row": "rolling_ratio_gage_row", "mean speed": "mean_speed_ratio", "slip of the gage row": "net_slip_gage_row"}
    m.write("fifty.csv", ({"cone": c["name"]} | {name: f"{c[key]:.4f}" for name, key in columns.items()} for c in cones))
