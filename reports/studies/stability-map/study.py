"""Maps of stick-slip of bit B on 2500 m of drill string, over weight and rotary speed: the 3-D bit, and a regenerative bit without a shape."""

import json
from pathlib import Path

import numpy as np
from study import read_case
from study_tools import ROOT, read_rows

HERE = Path(__file__).resolve().parent
DESIGN, CASE = "cases/sweeps/stability-map.toml", "cases/string-stick-slip.toml"
BLADES, BIT_MASS, BIT_INERTIA = 5, 38.49, 0.13518  # of bit B: kg, kg m2
DEPTHS, SPEEDS = (2.0, 5.0, 8.0, 11.0), (40.0, 80.0, 140.0)  # mm a turn at the middle speed; rpm at the middle depth
FIGURES = {"diagnosis.stick_slip_severity": "severity", "diagnosis.stuck_share": "stuck_share", "diagnosis.wob_swing": "weight_swing",
           "diagnosis.lost_contact_share": "lost_contact_share", "rop_mean_m_per_s": "rate_mm_s", "rotary_speed_mean_rad_per_s": "speed_rad_s",
           "wob_mean_n": "weight_n", "tob_mean_n_m": "torque_n_m"}
POINTS = ((80, 70), (80, 130))  # kN, rpm: of levels.csv
LEVELS = ((5.0, 2.0), (3.5, 2.0), (5.0, 1.0))  # edges in mm, steps in ms; the first is the map's
PRESCRIBED = """[bit]
file = "{bit}"
[rock]
shape = "conforming"
edge_length = "2 mm"
wall = "30 mm"
material = "berea-sandstone"
[motion]
kind = "steady"
rotary_speed = "{rpm} rpm"
rate_of_penetration = {rate}
[time]
step = "{step} ms"
revolutions = 2
[forces]
{law}
"""
SIMPLE = """[string]
model = "chain"
mass = {mass}
torsional_inertia = {inertia}
{sections}
[string.friction]
{friction}
[string.top]
{top}
[string.bit]
law = "regenerative"
axial_stiffness = {k}
torsional_stiffness = {t}
contact_force = {w0}
contact_lever = {lever}
pitch = "{pitch} deg"
axial_damping = "2e5 N s/m"
[motion]
rotary_speed = "{rpm} rpm"
rate_of_penetration = {rate}
weight_at_start = "{weight} kN"
torque_at_start = "{torque}"
[time]
step = "1 ms"
duration = "{duration} s"
"""
# column, label, colour map, limits
SHOWN = (("severity", "stick-slip severity", "magma_r", (0.0, 1.6)), ("weight_swing", "swing of weight", "viridis_r", (0.0, 0.6)),
         ("rate_mm_s", "rate (mm/s)", "cividis", (0.0, None)))

# The figure.


def grid(rows, key):
    """(weights, speeds, values[weight, speed])."""
    weights, speeds = (sorted({float(r[k]) for r in rows}) for k in ("weight_kn", "rpm"))
    found = {(float(r["weight_kn"]), float(r["rpm"])): float(r[key]) for r in rows}
    return weights, speeds, np.array([[found[w, s] for s in speeds] for w in weights])


def draw_values(ax, values, low, top, reverse, form):
    from figures import style
    for (i, j), value in np.ndenumerate(values):
        dark = (value - low) / (top - low)
        pale = dark > 0.55 if reverse else dark < 0.5
        text, colour = ("stuck", None) if np.isnan(value) else (format(value, form), "white" if pale else style.BLACK)
        ax.text(j, i, text, ha="center", va="center", fontsize=7, **({"color": colour} if colour else {}))


def figure():
    """Maps of severity, swing of weight and rate of both bits."""
    from figures import style
    maps = [("bit B in rock", read_rows(HERE / "map.csv")), ("regenerative bit", read_rows(HERE / "simple.csv"))]
    drawing, axes = style.panels(2, 3, (11.0, 6.6))
    for column, (key, words, colours, (low, high)) in enumerate(SHOWN):
        top = high or max(np.nanmax(grid(rows, key)[2]) for _, rows in maps)
        for row, (name, rows) in enumerate(maps):
            ax = axes[row, column]
            weights, speeds, values = grid(rows, key)
            shown = ax.imshow(values, origin="lower", aspect="auto", cmap=colours, vmin=low, vmax=top)
            draw_values(ax, values, low, top, colours.endswith("_r"), ".1f" if key == "rate_mm_s" else ".2f")
            ax.set(xticks=range(len(speeds)), xticklabels=[f"{s:g}" for s in speeds], yticks=range(len(weights)),
                   yticklabels=[f"{w:g}" for w in weights], title=f"{name}: {words}")
            ax.grid(False)
            if row == 1:
                ax.set_xlabel("rotary speed of the top (rpm)")
            if column == 0:
                ax.set_ylabel("weight on bit (kN)")
        drawing.colorbar(shown, ax=axes[:, column], shrink=0.7, extend="max" if high else "neither")
    return drawing


# Measurement.


def lines(table):
    """A table of keys with plain values as TOML."""
    return "\n".join(f"{key} = {json.dumps(value)}" for key, value in table.items())


def seconds(text):
    return float(str(text).split()[0])


def prescribed(m, depth, rpm):
    """Weight and torque at a given advance, mm a turn, and rotary speed."""
    text = PRESCRIBED.format(bit=ROOT / "cases/bits/bit-b.toml", rpm=rpm, rate=1e-3 * depth * rpm / 60.0, step=80.0 / rpm, law=lines(read_case(CASE)["forces"]))
    s = m.run(m.case(text)).summary
    return {"depth_mm": depth, "rpm": rpm, "weight_n": round(s["wob_mean_n"], 2), "torque_n_m": round(s["tob_mean_n_m"], 3)}


def sweep(m, threads=2):
    """The map of the 3-D bit, from the shipped design. A sweep in the folder of --results is resumed."""
    import xarray
    table = (m.results or m.temporary) / "map.nc"
    table.parent.mkdir(parents=True, exist_ok=True)
    m.output("tdbd", "sweep", ROOT / DESIGN, "-o", table, "--threads", str(threads), "--quiet")
    with xarray.open_dataset(table, decode_times=False) as data:
        columns = {name: data[name].values for name in ("motion.weight_at_start", "motion.rotary_speed", *FIGURES)}
    for i, rpm in enumerate(columns["motion.rotary_speed"]):
        yield {"weight_kn": seconds(columns["motion.weight_at_start"][i]), "rpm": seconds(rpm),
               **{name: round(float(columns[key][i]) * (1e3 if name == "rate_mm_s" else 1.0), 5) for key, name in FIGURES.items()}}


def simple_row(m, forces, weight, rpm):
    """The bit without a shape at one point, measured like the diagnosis of a run. Its weight is w0 + k d and its torque t0 + t d, where
    d is the depth of cut of all blades. Units: N, N/m, N m, N."""
    middle = [r for r in forces if r["rpm"] == SPEEDS[1]]
    (k, w0), (t, t0) = (np.polyfit([1e-3 * r["depth_mm"] for r in middle], [r[key] for r in middle], 1) for key in ("weight_n", "torque_n_m"))
    design, string = read_case(DESIGN), read_case(CASE)["string"]
    text = SIMPLE.format(mass=BIT_MASS, inertia=BIT_INERTIA, sections="\n".join(f"[[string.sections]]\n{lines(s)}" for s in string["sections"]),
                         friction=lines(string["friction"]), top=lines(string["top"]), k=BLADES * k, t=BLADES * t, w0=w0, lever=t0 / w0,
                         pitch=360.0 / BLADES, rpm=rpm, rate=max(1e3 * weight - w0, 0.0) / k * rpm / 60.0, weight=weight,
                         torque=design["set"]["motion"]["torque_at_start"], duration=seconds(design["set"]["time"]["duration"]))
    data = m.run(m.case(text), command="string").history
    late = data["time"].values >= seconds(design["set"]["output"]["means_from"])
    time, speed, load, place = (data[name].values[late] for name in ("time", "speed", "weight", "displacement"))
    mean = speed.mean()
    return {"weight_kn": weight, "rpm": rpm, "severity": round((speed.max() - speed.min()) / (2.0 * mean), 5) if mean > 0.0 else "nan",
            "stuck_share": round(float((speed <= 0.05 * mean).mean()), 5),
            "weight_swing": round(float(np.ptp(load) / (2.0 * load.mean())), 5), "lost_contact_share": round(float((load <= 0.0).mean()), 5),
            "rate_mm_s": round(1e3 * (place[-1] - place[0]) / (time[-1] - time[0]), 5), "speed_rad_s": round(float(mean), 5)}


def level(m, rows, point, edge, step):
    """A point of the map with other edges and another step."""
    weight, rpm = point
    place = {"weight_kn": weight, "rpm": rpm, "edge_mm": edge, "step_ms": step}
    if (edge, step) == LEVELS[0]:
        row = next(r for r in rows if (r["weight_kn"], r["rpm"]) == point)
        return place | {key: round(row[key], 4) for key in ("severity", "stuck_share", "weight_swing", "rate_mm_s")}
    given = {f"{table}.{key}": value for table, keys in read_case(DESIGN)["set"].items() for key, value in keys.items()}
    given |= {"motion.weight_at_start": f"{weight} kN", "motion.rotary_speed": f"{rpm} rpm", "rock.edge_length": f"{edge} mm", "time.step": f"{step} ms"}
    s = m.run(CASE, given).summary
    d = s["diagnosis"]
    return place | {"severity": round(d["stick_slip_severity"], 4), "stuck_share": round(d["stuck_share"], 4),
                    "weight_swing": round(d["wob_swing"], 4), "rate_mm_s": round(1e3 * s["rop_mean_m_per_s"], 4)}


def measure(m):
    runs = [(depth, SPEEDS[1]) for depth in DEPTHS] + [(DEPTHS[1], rpm) for rpm in SPEEDS if rpm != SPEEDS[1]]
    m.write("forces.csv", (prescribed(m, *run) for run in runs))
    forces, rows = read_rows(HERE / "forces.csv"), list(sweep(m))
    m.write("map.csv", rows)
    m.write("simple.csv", (simple_row(m, forces, r["weight_kn"], r["rpm"]) for r in rows))
    m.write("levels.csv", (level(m, rows, p, *size) for p in POINTS for size in LEVELS))
