"""A bit that whirls in the rock that it cuts, compared with a bit on a ring of fixed radius, over edges and time steps."""

import re

import numpy as np
from study_tools import ROOT
from result import read_ply

CASE = ROOT / "cases/drill-bit-b-whirl-rock.toml"
# wall, edges in mm, step in ms
RUNS = [("rock", edge, step) for edge in (3, 2.1, 1.5) for step in (0.5, 0.25, 0.125)] + [("rock", 1.05, 0.25)] + \
    [("ring", edge, step) for edge in (3, 1.5) for step in (0.5, 0.25, 0.125)]
SHOWN = (1.5, 0.25)
RING = """[wall]
stiffness = "1e8 N/m"
clearance = "3 mm"
ring_height = "80 mm"
restitution = 0.5
friction = 1.0
"""
SECTION_ABOVE = 0.085  # m above the bit's nose: the middle of the pads
SECTORS = 360


def lobes(radii):
    """The number of waves around the hole with the greatest amplitude, beyond the three of a shifted or oval hole."""
    waves = np.abs(np.fft.rfft(radii - radii.mean()))
    return int(np.argmax(waves[4:]) + 4)


def case_of(m, wall):
    """The case; or the same bit, string and rock with a ring instead of the wall of the rock, which is moved out of reach."""
    if wall == "rock":
        return CASE
    text = re.sub(r'\[wall\]\nmodel = "rock"\nfriction = 1.0\n', RING, CASE.read_text(encoding="utf-8"))
    return m.case(text.replace('radius = "110.95 mm"', 'radius = "118 mm"').replace('"bits/', f'"{ROOT}/cases/bits/'), "ring.toml")


def section(ply, height):
    """Radius of the hole at a height, m, in each sector about the centre of the hole: the farthest vertex within 2 mm."""
    points = np.asarray(read_ply(ply)[0])
    near = points[np.abs(points[:, 2] - height) < 2e-3]
    sectors = ((np.arctan2(near[:, 1], near[:, 0]) / (2 * np.pi)) % 1 * SECTORS).astype(int)
    radius = np.full(SECTORS, np.nan)
    for k, r in zip(sectors, np.hypot(near[:, 0], near[:, 1])):
        radius[k] = np.fmax(radius[k], r)
    known = np.flatnonzero(~np.isnan(radius))
    return np.interp(np.arange(SECTORS), known, radius[known], period=SECTORS)


def row_of(wall, edge, step, s):
    d, energy = s["diagnosis"], s["energy"]
    pads = sum(e for name, e in energy["cutting_by_part_j"].items() if "pad" in name)
    return {"wall": wall, "edges, mm": edge, "step, ms": step, "orbit, mm": f"{1e3 * d['orbit_radius_m']:.3f}",
            "whirl, Hz": f"{d['orbit_frequency_hz']:.2f}", "rolling on that orbit, Hz": f"{d['rolling_frequency_at_orbit_hz']:.2f}",
            "advance, mm/s": f"{1e3 * s['rop_mean_m_per_s']:.3f}", "weight, kN": f"{1e-3 * s['wob_mean_n']:.3f}",
            "torque, N m": f"{s['tob_mean_n_m']:.0f}", "removed, cm3": f"{1e6 * s['removed_volume_m3']:.1f}",
            "spent by pads, kJ": f"{1e-3 * pads:.2f}", "from the top, kJ": f"{1e-3 * energy['top_j']:.2f}", "residual, J": f"{energy['residual_j']:.2f}"}


def measure(m):
    rows, orbits = [], []
    for wall, edge, step in RUNS:
        run = m.run(case_of(m, wall), {"rock.edge_length": f"{edge} mm", "time.step": f"{step} ms"})
        rows.append(row_of(wall, edge, step, run.summary))
        if (edge, step) == SHOWN:
            late = run.history.isel(time=run.history.time.values > 0.9)
            orbits += [{"wall": wall, "x, mm": f"{1e3 * x:.4f}", "y, mm": f"{1e3 * y:.4f}"}
                       for x, y in zip(late.position_x.values, late.position_y.values)]
            if wall == "rock":
                radii = section(run.folder / "rock_final.ply", float(run.history.position_z.values[-1]) - SECTION_ABOVE)
                m.write("sections.csv", ({"azimuth, deg": k + 0.5, "radius, mm": f"{1e3 * r:.3f}"} for k, r in enumerate(radii)))
    m.write("walls.csv", rows)
    m.write("orbits.csv", orbits)
