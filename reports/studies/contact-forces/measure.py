#!/usr/bin/python3
"""Contact forces over the edge length: single parts that are pressed into flat rock and slide in it, against the exact
area of their own facets. Writes contacts.csv beside itself in some ten minutes; requires a release build.

    measure.py
    measure.py --program PROGRAM              another build's tdbd
    measure.py --only ball wedge              some contacts, prints their rows only
    measure.py --only ball --program PROGRAM --write ball-before.csv
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import tempfile

import numpy as np
import xarray
from scipy.spatial import ConvexHull

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
EDGES = (1.6, 1.13, 0.8, 0.57, 0.4)  # mm
STRESS = 100e6  # Pa: ratio 1 of the law, a rock of 100 MPa
PRESS, SLIDE = 100.0, 100.0  # mm/s
FROM = 0.06  # s, of the slide, until a part has left the place where it was pressed


def prism(outline, length):
    """Of an outline (x, z) along y."""
    return np.array([(x, y, z) for y in (-length / 2, length / 2) for x, z in outline])


def turned(corners, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return corners @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def tilted(corners, degrees):
    """Leans forward; the lowest corner comes back to z = 0."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    corners = corners @ np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    return corners - [0, 0, corners[:, 2].max()]


def ball(radius=6.0, rings=40):
    points = [(0, 0, 0), (0, 0, -2 * radius)]
    for i in range(1, rings):
        turn = math.pi * i / rings
        for k in range(2 * rings):
            angle = math.pi * (k + 0.5 * (i % 2)) / rings
            points.append((radius * math.sin(turn) * math.cos(angle), radius * math.sin(turn) * math.sin(angle),
                           radius * math.cos(turn) - radius))
    return np.array(points)


def cone(half_angle=60.0, depth=4.0, facets=48):
    r = depth * math.tan(math.radians(half_angle))
    rim = [(r * math.cos(2 * math.pi * i / facets), r * math.sin(2 * math.pi * i / facets), -depth) for i in range(facets)]
    return np.array([(0, 0, 0), *rim])


def disc(radius=4.0, height=8.0, facets=64):
    turn = 2 * math.pi * np.arange(facets) / facets
    x, y = radius * np.cos(turn), radius * np.sin(turn)
    return np.concatenate([np.stack([x, y, np.full(facets, z)], axis=1) for z in (0.0, -height)])


WEDGE = prism([(0, 0), (7, -4), (-7, -4)], 10)  # sides at 60 degrees to the axis
TOOTH = prism([(1, 0), (-1, 0), (-4.7, -8), (4.7, -8)], 8)  # flanks at 25 degrees, a crest of 2 mm


def box(x, y, z):
    return prism([(-x / 2, 0), (x / 2, 0), (x / 2, -z), (-x / 2, -z)], y)


# name: corners (mm, z down, lowest at 0), depth (mm), sinking speed while it slides (mm/s), law
CONTACTS = {
    "ball": (ball(), 2.0, 0.0, "indentation"),
    "cone": (cone(), 2.0, 0.0, "indentation"),
    "wedge": (WEDGE, 2.0, 0.0, "indentation"),
    "wedge yawed 37 deg": (turned(WEDGE, 37), 2.0, 0.0, "indentation"),
    "milled tooth yawed 20 deg": (turned(TOOTH, 20), 2.0, 8.0, "indentation"),
    "flat punch": (box(9, 6, 8), 1.5, 8.0, "indentation"),
    "flat punch yawed 23 deg": (turned(box(9, 6, 8), 23), 1.5, 8.0, "indentation"),
    "block tilted 12 deg": (tilted(turned(box(9, 6, 8), 23), 12), 1.5, 8.0, "indentation"),
    "wear flat": (disc(), 0.5, 8.0, "friction"),
    "pad": (box(15, 10, 8), 0.3, 8.0, "friction"),
}


def facets(corners):
    """Triangles of the convex hull, counter-clockwise seen from outside."""
    hull = ConvexHull(corners)
    triangles = []
    for t, plane in zip(hull.simplices, hull.equations):
        a, b, c = corners[t]
        triangles.append(t if np.dot(np.cross(b - a, c - a), plane[:3]) > 0 else t[::-1])
    return np.array(triangles)


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


def write_case(folder, corners, triangles, depth, sinks, law, edge):
    with open(folder / "part.off", "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(corners)} {len(triangles)} 0\n")
        file.writelines(f"{x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in corners)
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)
    kind = "tooth" if law == "indentation" else "gage-pad"
    (folder / "bit.toml").write_text(
        'name = "part"\nunit_check = "off"\n[[parts]]\nname = "part"\nkind = "' + kind +
        '"\nfile = "part.off"\nunit = "1 mm"\nupdate_direction = [0, 0, 1]\n', encoding="utf-8")
    strength = 'ratio = 1\n' if law == "indentation" else 'stress = "100 MPa"\nfull_angle = 0\n'
    press = depth / PRESS
    (folder / "case.toml").write_text(f'''
[bit]
file = "bit.toml"
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
velocity = ["0 mm/s", "0 mm/s", "{PRESS} mm/s"]
[[motion.legs]]
duration = "0.14 s"
velocity = ["{SLIDE} mm/s", "0 mm/s", "{sinks} mm/s"]
[time]
step = "0.5 ms"
[forces]
law = "{law}"
mu = 0
slip_speed = "0.001 mm/s"
{strength}
[output]
history_every = 1
''', encoding="utf-8")


def drill(program, folder):
    result = subprocess.run([str(program), "run", str(folder / "case.toml"), "-o", str(folder / "run"), "--force"],
                            capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(result.stderr)
    with xarray.open_dataset(folder / "run" / "history.nc") as history:
        return history.load()


def measured(program, name, edge):
    """Forces over exact ones at one edge length: at the end of the press, and on average over the slide."""
    corners, depth, sinks, law = CONTACTS[name]
    triangles = facets(corners)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        write_case(folder, corners, triangles, depth, sinks, law, edge)
        history = drill(program, folder)
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


def orders(rows):
    """Least squares over the levels, of each ratio's distance from 1; the share of the finest."""
    edges = np.log([r["edges, mm"] for r in rows])
    found = {"contact": rows[0]["contact"]}
    for column in ("pressed weight", "weight", "drag"):
        errors = np.abs([r[column] - 1.0 for r in rows])
        found[column + ": order"] = np.polyfit(edges, np.log(np.maximum(errors, 1e-12)), 1)[0]
        found[column + ": at 0.4 mm"] = rows[-1][column]
    return found


def write(name, rows):
    with open(HERE / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.4f}" if isinstance(v, float) and k != "edges, mm" else v for k, v in row.items()}
                         for row in rows)


def main():
    parser = argparse.ArgumentParser(description="Contact forces over the edge length.")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/tdbd")
    parser.add_argument("--only", nargs="+", choices=CONTACTS, help="prints the rows of these contacts")
    parser.add_argument("--write", metavar="NAME", help="with --only: writes the rows to this file beside the script")
    arguments = parser.parse_args()
    rows = []
    for name in arguments.only or CONTACTS:
        rows += [measured(arguments.program, name, edge) for edge in EDGES]
        for row in rows[-len(EDGES):]:
            print(json.dumps({k: round(v, 4) if isinstance(v, float) else v for k, v in row.items()}), flush=True)
    if arguments.write:
        write(arguments.write, rows)
    if not arguments.only:
        write("contacts.csv", rows)
        write("orders.csv", [orders(rows[i:i + len(EDGES)]) for i in range(0, len(rows), len(EDGES))])


if __name__ == "__main__":
    main()
