#!/usr/bin/python3
"""A bit that whirls in the rock that it cuts, beside one on a ring of fixed radius: cases/drill-bit-b-whirl-rock over
edges and time steps, and the same bit on a ring. Writes walls.csv, orbits.csv and sections.csv beside itself, three minutes;
requires a release build.

    measure.py [--tdbd PROGRAM]
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np
import xarray

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "reports"))
from study_surfaces import read_ply  # noqa: E402
from study_tools import write_rows  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CASE = ROOT / "cases/drill-bit-b-whirl-rock.toml"
EDGES, STEPS = [3, 2.1, 1.5, 1.05], [0.5, 0.25, 0.125]  # mm, ms
RING = """[wall]
stiffness = "1e8 N/m"
clearance = "3 mm"
ring_height = "80 mm"
restitution = 0.5
friction = 1.0
"""
SECTION_ABOVE = 0.085  # m above the bit's nose: the middle of the pads
SECTORS = 360


def ring_case(folder):
    """The same bit, string and rock; the rock's wall out of reach, a ring instead."""
    text = CASE.read_text(encoding="utf-8")
    text = re.sub(r'\[wall\]\nmodel = "rock"\nfriction = 1.0\n', RING, text)
    text = text.replace('radius = "110.95 mm"', 'radius = "118 mm"').replace('"bits/', f'"{ROOT}/cases/bits/')
    file = pathlib.Path(folder) / "ring.toml"
    file.write_text(text, encoding="utf-8")
    return file


def drill(tdbd, case, out, edge, step):
    subprocess.run([tdbd, "run", case, "-o", out, "--force", "--quiet", "--set", f"rock.edge_length='{edge} mm'",
                    "--set", f"time.step='{step} ms'"], check=True)
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    with xarray.open_dataset(out / "history.nc") as history:
        return summary, history.load()


def lobes(radii):
    """The number of waves around the hole with the greatest amplitude, beyond the three of a shifted or oval hole."""
    waves = np.abs(np.fft.rfft(radii - radii.mean()))
    return int(np.argmax(waves[4:]) + 4)


def section(out, height):
    """Radius of the hole at this height, m, for each sector, about its middle: the farthest vertex within 2 mm."""
    points = np.asarray(read_ply(out / "rock_final.ply")[0])
    near = points[np.abs(points[:, 2] - height) < 2e-3]
    sectors = ((np.arctan2(near[:, 1], near[:, 0]) / (2 * np.pi)) % 1 * SECTORS).astype(int)
    radius = np.full(SECTORS, np.nan)
    for k, r in zip(sectors, np.hypot(near[:, 0], near[:, 1])):
        radius[k] = np.fmax(radius[k], r)
    known = np.flatnonzero(~np.isnan(radius))
    return np.interp(np.arange(SECTORS), known, radius[known], period=SECTORS)


def row_of(wall, edge, step, summary):
    d = summary["diagnosis"]
    pads = sum(e for name, e in summary["energy"]["cutting_by_part_j"].items() if "pad" in name)
    return {"wall": wall, "edges, mm": edge, "step, ms": step, "orbit, mm": f"{1e3 * d['orbit_radius_m']:.3f}",
            "whirl, Hz": f"{d['orbit_frequency_hz']:.2f}", "rolling on that orbit, Hz": f"{d['rolling_frequency_at_orbit_hz']:.2f}",
            "advance, mm/s": f"{1e3 * summary['rop_mean_m_per_s']:.3f}", "weight, kN": f"{1e-3 * summary['wob_mean_n']:.3f}",
            "torque, N m": f"{summary['tob_mean_n_m']:.0f}", "removed, cm3": f"{1e6 * summary['removed_volume_m3']:.1f}",
            "spent by pads, kJ": f"{1e-3 * pads:.2f}", "from the top, kJ": f"{1e-3 * summary['energy']['top_j']:.2f}",
            "residual, J": f"{summary['energy']['residual_j']:.2f}"}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tdbd", default=str(ROOT / "build/release/tdbd"))
    tdbd = parser.parse_args().tdbd
    rows, orbits = [], {}
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        for wall, case in (("rock", CASE), ("ring", ring_case(folder))):
            for edge in EDGES:
                for step in STEPS:
                    if (edge < 1.5 and step != 0.25) or (wall == "ring" and edge not in (3, 1.5)):
                        continue
                    summary, history = drill(tdbd, case, out, edge, step)
                    rows.append(row_of(wall, edge, step, summary))
                    print(rows[-1], flush=True)
                    if edge == 1.5 and step == 0.25:
                        late = history.time.values > 0.9
                        orbits[wall] = history.position_x.values[late], history.position_y.values[late]
                        if wall == "rock":
                            radius = section(out, float(history.position_z.values[-1]) - SECTION_ABOVE)
                            print("lobes", lobes(radius))
                            write_rows(HERE / "sections.csv", [{"azimuth, deg": k + 0.5, "radius, mm": f"{1e3 * r:.3f}"}
                                                               for k, r in enumerate(radius)])
    write_rows(HERE / "walls.csv", rows)
    write_rows(HERE / "orbits.csv", [{"wall": wall, "x, mm": f"{1e3 * x:.4f}", "y, mm": f"{1e3 * y:.4f}"}
                                     for wall, (xs, ys) in orbits.items() for x, y in zip(xs, ys)])


if __name__ == "__main__":
    main()
