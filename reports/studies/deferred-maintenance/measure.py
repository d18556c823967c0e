#!/usr/bin/python3
"""How long should rock rest before it is maintained? Writes rests.csv beside itself: the standard
workload with several values of maintenance.rest. Wants a release build with the target long-run.

    measure.py                    all rows, some minutes
    measure.py --rests 0 4        only these
    measure.py --program PROGRAM  another build's long-run

The surface is compared at the end with that of much finer edges, over the bottom from r = 2 to
106 mm: the vertical distance times the cosine of the fine surface's slope.
"""

import argparse
import csv
import pathlib
import re
import subprocess
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
CELL, REACH = 0.25e-3, 0.107
REVOLUTIONS = 3


def drill(program, folder, edges, rest):
    ply = pathlib.Path(folder) / f"{edges}-{rest}.ply"
    command = [str(program), str(ROOT / "cases/standard-workload.toml"), "--rows", "1", "--save", str(ply)]
    for setting in (f"rock.edge_length='{edges} mm'", f"maintenance.rest={rest}",
                    f"time.revolutions={REVOLUTIONS}"):
        command += ["--set", setting]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode == 2:
        raise SystemExit(result.stderr)
    return result.stdout, heights(*read_ply(ply))


def read_ply(path):
    """Positions and triangles of a binary or text PLY file as this program writes it."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:end].decode()
    vertices = int(re.search(r"element vertex (\d+)", head)[1])
    faces = int(re.search(r"element face (\d+)", head)[1])
    if "format ascii" in head:
        numbers = data[end:].split()
        x = np.array(numbers[:3 * vertices], dtype=float).reshape(-1, 3)
        t = np.array(numbers[3 * vertices:], dtype=int).reshape(faces, 4)[:, 1:]
        return x, t
    x = np.frombuffer(data, "<f8", 3 * vertices, end).reshape(-1, 3)
    kind = np.dtype([("n", "u1"), ("v", "<i4", 3)])
    return x, np.frombuffer(data, kind, faces, end + 24 * vertices)["v"]


def heights(x, t):
    """z of the highest triangle over every point of a square grid (z is down)."""
    n = int(2 * REACH / CELL) + 1
    z = np.full((n, n), np.inf)
    a, b, c = ((x[t[:, k]] + [REACH, REACH, 0]) / [CELL, CELL, 1] for k in range(3))
    lo = np.ceil(np.minimum(np.minimum(a, b), c)[:, :2]).astype(int)
    hi = np.floor(np.maximum(np.maximum(a, b), c)[:, :2]).astype(int)
    twice = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    most = (hi - lo).max(axis=0)
    for i in range(most[0] + 1):
        for k in range(most[1] + 1):
            p = lo + [i, k]
            inside = (p <= hi).all(axis=1) & (p >= 0).all(axis=1) & (p < n).all(axis=1) & (abs(twice) > 1e-12)
            s = np.flatnonzero(inside)
            q, d = p[s].astype(float), twice[s]
            def weight(u, v):
                return ((v[s, 0] - u[s, 0]) * (q[:, 1] - u[s, 1]) - (v[s, 1] - u[s, 1]) * (q[:, 0] - u[s, 0])) / d
            wc, wa = weight(a, b), weight(b, c)
            wb = 1 - wa - wc
            hit = (wa >= -1e-9) & (wb >= -1e-9) & (wc >= -1e-9)
            s = s[hit]
            depth = wa[hit] * a[s, 2] + wb[hit] * b[s, 2] + wc[hit] * c[s, 2]
            np.minimum.at(z, (p[s, 0], p[s, 1]), depth)
    return z


def errors(fine, z):
    n = fine.shape[0]
    at = np.arange(n) * CELL - REACH
    r = np.hypot(at[:, None], at[None, :])
    with np.errstate(invalid="ignore"):  # beyond the rock
        slope = np.hypot(*np.gradient(fine, CELL))
        distance = abs(z - fine) / np.sqrt(1 + slope**2)
    distance = distance[(r >= 2e-3) & (r <= 0.106) & np.isfinite(distance)]
    return 1e3 * distance.mean(), 1e3 * np.percentile(distance, 95)


def figures(text):
    row = next(line for line in text.splitlines() if re.match(r" *\d+ +\d+\.\d\d ", line)).split()
    def number(pattern):
        found = re.search(pattern, text, re.M)
        return float(found[1]) if found else 0.0
    thousands = float(row[0]) / 1000
    bisections = number(r"^bisections (\d+)") / thousands
    moves = number(r"by a step of the last row ([0-9.]+)")
    return {
        "bisections in 1000 steps": f"{bisections:.0f}",
        "triangles at the end": row[2],
        "moves a step": f"{moves:.0f}",
        "worst quality": row[4],
        "1 % quality": row[5],
        "disturbed over removed": row[6],
        "us a plain step": row[8],
        "ns a touched triangle": row[9],
        "pairs": row[3],
        "broken promises": " ".join(row[10:]),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rests", type=int, nargs="*", default=[0, 1, 2, 4])
    parser.add_argument("--edges", nargs="*", default=["1.0"])
    parser.add_argument("--fine", default="0.5", help="edges of the surface to compare with, mm")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/verification/long_run/long-run")
    parser.add_argument("--out", type=pathlib.Path, default=HERE / "rests.csv")
    arguments = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        _, fine = drill(arguments.program, folder, arguments.fine, 0)
        for edges in arguments.edges:
            for rest in arguments.rests:
                text, z = drill(arguments.program, folder, edges, rest)
                mean, p95 = errors(fine, z)
                rows.append({"edges, mm": edges, "rest, steps": rest, **figures(text),
                             "surface error, mean and p95, mm": f"{mean:.4f}, {p95:.4f}"})
                print(rows[-1], flush=True)
    with arguments.out.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
