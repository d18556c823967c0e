"""A bit at rest: the shipped stick-slip, and the same bit without rotation, at several edges and steps.

The files -before.csv were measured 2026-11-23 with a program whose impulses were explicit in every step.
"""

import numpy as np

LEVELS = [(edges, step) for edges in (3.0, 2.0) for step in (3.0, 2.0, 1.0, 0.5)]  # mm, ms
STICK, QUIET = 0.5, 0.04  # rad/s, s: the bit is stuck at times at which it turns slower for this time on both sides
FALLEN = 1.0  # s: by then faces and bodies carry a bit that is not turned
PLUNGE = {"time.duration": "3 s", "motion.rotary_speed": "0 rpm", "motion.torque_at_start": 0}


def drill(m, settings):
    """A run with a row of the history for each step."""
    return m.run("cases/stick-slip.toml", {**settings, "measure.section_at_face": "as_ahead", "output.history_every": 1})


def stuck_steps(history, step):
    """Steps at which the bit is stuck and was stuck one step before."""
    moves = np.abs(history.rotary_speed.values) >= STICK
    reach = round(QUIET / step)
    near = np.convolve(moves, np.ones(2 * reach + 1), "same") > 0
    return ~near[1:] & ~near[:-1]


def row(m, settings, edges, step):
    """Values over the steps in which the bit is stuck, or for a bit that is not turned over the steps after its fall."""
    run = drill(m, {**settings, "rock.edge_length": f"{edges} mm", "time.step": f"{step} ms"})
    h, turns = run.history, settings is not PLUNGE
    chosen = stuck_steps(h, 1e-3 * step) if turns else h.time.values[1:] > FALLEN
    weight, z = h.weight_on_bit.values, h.position_z.values
    change = np.diff(weight)[chosen] / np.mean(weight[1:][chosen])
    found = {"edges, mm": edges, "step, ms": step, "change of weight": f"{np.sqrt(np.mean(change**2)):.1e}",
             "creep, mm/s": f"{1e3 * np.mean(np.diff(z)[chosen]) / (1e-3 * step):.3f}"}
    if turns:
        found |= {"depth at 6 s, mm": f"{1e3 * z[-1]:.2f}", "residual of energy, J": f"{h.energy_residual.values[-1]:.4f}"}
    else:
        found |= {"depth at 1 s, mm": f"{1e3 * np.interp(FALLEN, h.time.values, z):.2f}", "depth at 3 s, mm": f"{1e3 * z[-1]:.2f}"}
    solved = run.summary["counters"]["implicit_forces"]
    return found | {"steps solved": solved["steps"], "unsettled": solved["unsettled"], "most rounds": solved["most_rounds"]}


def whole_case(m):
    s = drill(m, {"time.duration": "20 s"}).summary
    seen = s["diagnosis"]
    return {"program": "now", "rate of penetration, mm/s": f"{1e3 * s['rop_mean_m_per_s']:.3f}", "stuck share": f"{seen['stuck_share']:.3f}",
            "frequency, Hz": f"{seen['torsional_frequency_hz']:.3f}", "severity": f"{seen['stick_slip_severity']:.2f}"}


def measure(m):
    m.write("sticks.csv", (row(m, {"time.duration": "6 s"}, *level) for level in LEVELS))
    m.write("plunges.csv", (row(m, PLUNGE, *level) for level in LEVELS))
    m.write("case.csv", [whole_case(m)])
