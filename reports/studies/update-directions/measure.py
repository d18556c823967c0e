#!/usr/bin/env python3
"""measure.py BUILD FOLDER: what each rule for the update direction does, as tables.

Figures 4.7 to 4.9 of the thesis compare the rules (eq. 4.2) for PDC bits; `gage_teeth` is their
counterpart for roller cone bits. Runs BUILD/tdbd once for each rule and mesh, keeps the results below
FOLDER, and writes there, in SI:

cut.csv     in two dimensions: bit, rule, revolution, vertex, r_m, z_m of the rock's vertices that start
            in the half-plane y = 0, x > 0, drilled without maintenance, so that a vertex keeps its
            number. A vertex stays in its half-plane: `off_plane_m` says how nearly.
meshes.csv  in three dimensions, with maintenance: bit, rule, revolutions, volume of the last full one
            over pi R^2 d, triangles at the end over those at the start, pairs of intersecting
            triangles, worst quality, quality that 99 % exceed, what maintenance changed over what was
            removed, and why the run stopped (empty: it did not).
sections.csv  the same surfaces in the half-plane: bit, rule, segment, and (r, z) of its two ends.

meshes.csv goes beside this script, too, with fewer digits.

What folds depends on the time step, and on what heals: with inside cutters along -X bit B has intersecting pairs
after a third of a revolution without maintenance of shapes, and none with it (directions_test). A minute for bit B
and bit R at 3 mm edges.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from result import read_surface  # noqa: E402

CASES = pathlib.Path(__file__).resolve().parents[3] / "cases"
EDGE = 3e-3  # m
BITS = {  # case, key of the rule, rules, settings of both runs, revolutions of each
    "bit-b": ("bit-b-steady.toml", "update.directions", ["hybrid", "all-down", "along-profile"],
              {"motion.rate_of_penetration": "60 m/h", "time.step": "5 ms"}, 4, 9),
    "bit-b inside": ("bit-b-steady.toml", "update.inside_cutters", ["down", "minus-x", "plus-x"],
                     {"time.step": "1 ms"}, 1, 0.34),
    "bit-r": ("bit-r-steady.toml", "update.gage_teeth", ["normal", "row", "down", "horizontal"],
              {"rock.wall": "60 mm", "time.step": "3 ms"}, 4, 8),
}


def run(build, case, folder, settings):
    """The folder of a run, whether it ended well or not."""
    command = [build / "tdbd", "run", CASES / case, "-o", folder, "--force", "--quiet"]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    subprocess.run(command, check=False, capture_output=True)
    return folder


def cut_rows(bit, rule, folder, frames):
    """Rows of cut.csv: every vertex of the half-plane in every frame."""
    surfaces = [read_surface(f) for f in frames]
    start = surfaces[0].points
    chosen = np.flatnonzero((np.abs(start[:, 1]) < 0.3 * EDGE) & (start[:, 0] >= 0.0))
    azimuth = np.arctan2(start[chosen, 1], start[chosen, 0])
    for revolution, surface in enumerate(surfaces):
        x, y, z = surface.points[chosen].T
        r = np.cos(azimuth) * x + np.sin(azimuth) * y
        off = np.cos(azimuth) * y - np.sin(azimuth) * x
        for k, vertex in enumerate(chosen):
            yield [bit, rule, revolution, vertex, r[k], z[k], off[k]]


def section_rows(bit, rule, surface):
    """Segments in which the triangles meet the plane y = 0 at x > 0."""
    corners = surface.corners
    side = corners[:, :, 1] > 0.0
    crossing = corners[side.any(axis=1) & ~side.all(axis=1)]
    number = 0
    for triangle in crossing:
        ends = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            ya, yb = triangle[a, 1], triangle[b, 1]
            if (ya > 0.0) != (yb > 0.0):
                ends.append(triangle[a] + ya / (ya - yb) * (triangle[b] - triangle[a]))
        if ends[0][0] > 0.0 and ends[1][0] > 0.0:
            yield [bit, rule, number, ends[0][0], ends[0][2], ends[1][0], ends[1][2]]
            number += 1


def pairs(build, surface):
    """Intersecting pairs of triangles, by CGAL's predicates."""
    tool = subprocess.run([build / "reference" / "tools" / "self-intersections", surface],
                          check=False, capture_output=True, text=True)
    for line in tool.stdout.splitlines():
        if line.startswith("self-intersecting pairs"):
            return int(line.split()[-1])
    return ""


def mesh_row(build, bit, rule, folder, advance):
    """A row of meshes.csv; a run that failed has a surface and a reason, but no summary."""
    found = pairs(build, folder / "rock_final.ply")
    failure = folder / "failure.txt"
    if failure.is_file():
        return [bit, rule, "", "", "", found, "", "", "", failure.read_text().strip()]
    s = json.loads((folder / "summary.json").read_text())
    full = int(s["revolutions"] + 1e-9)
    ideal = math.pi * s["gage_radius_m"] ** 2 * advance
    last = s["removed_volume_by_revolution_m3"][full - 1] / ideal if full else ""
    return [bit, rule, s["revolutions"], last, s["rock_triangles_end"] / s["rock_triangles_start"], found,
            s["rock_quality_min"], s["rock_quality_1_percent"],
            s["maintenance_volume_m3"] / s["removed_volume_m3"], ""]


def keep(meshes):
    """The table of this study: meshes.csv with four digits."""
    with open(meshes, newline="", encoding="utf-8") as file:
        headings, *rows = csv.reader(file)
    with open(pathlib.Path(__file__).with_name("meshes.csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([headings, *([short(cell) for cell in row] for row in rows)])


def short(cell):
    try:
        return f"{float(cell):.4g}"
    except ValueError:
        return cell


def speeds(folder):
    """Time step (s), time of a revolution (s) and advance in it (m) of a resolved case."""
    import tomllib
    case = tomllib.loads((folder / "case.toml").read_text())
    turn = 2.0 * math.pi / case["motion"]["rotary_speed"]
    return case["time"]["step"], turn, turn * case["motion"]["rate_of_penetration"]


def study(build, out, bit, writers):
    case, key, rules, settings, cut_turns, turns = BITS[bit]
    for rule in rules:
        name = f"{bit.replace(' ', '-')}-{rule}"
        common = {"rock.edge_length": EDGE, key: rule, **settings}
        whole = run(build, case, out / name, {**common, "time.revolutions": turns})
        step, turn, advance = speeds(whole)
        writers["meshes"].writerow(mesh_row(build, bit, rule, whole, advance))
        writers["sections"].writerows(
            section_rows(bit, rule, read_surface(whole / "frames" / "rock_final.vtp")))
        every = round(turn / step)
        start = run(build, case, out / f"{name}-start", {
            **common, "maintenance.every": 0, "time.revolutions": 1e-6, "time.step": 5e-7})
        cut = run(build, case, out / f"{name}-cut", {
            **common, "maintenance.every": 0, "time.revolutions": cut_turns,
            "output.frames_every": every})
        frames = [start / "frames" / "rock_final.vtp"]
        frames += sorted((cut / "frames").glob("rock-*.vtp"))
        writers["cut"].writerows(cut_rows(bit, rule, cut, frames))


HEADS = {
    "cut": ["bit", "rule", "revolution", "vertex", "r_m", "z_m", "off_plane_m"],
    "meshes": ["bit", "rule", "revolutions", "last_revolution_over_pi_R2_d", "triangles_end_over_start",
               "intersecting_pairs", "quality_min", "quality_1_percent", "maintenance_over_removed",
               "stopped"],
    "sections": ["bit", "rule", "segment", "r0_m", "z0_m", "r1_m", "z1_m"],
}


def main(build, out):
    out.mkdir(parents=True, exist_ok=True)
    files = {name: open(out / f"{name}.csv", "w", newline="", encoding="utf-8") for name in HEADS}
    writers = {name: csv.writer(file) for name, file in files.items()}
    for name, head in HEADS.items():
        writers[name].writerow(head)
    for bit in BITS:
        study(build, out, bit, writers)
        print(bit, "done", flush=True)
    for file in files.values():
        file.close()
    keep(out / "meshes.csv")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
