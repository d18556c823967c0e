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
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "reports"))
from study_surfaces import distances, heights, read_ply  # noqa: E402

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
    return result.stdout, heights(*read_ply(ply), REACH, CELL)


def errors(fine, z):
    distance = distances(fine, z, REACH, CELL, 2e-3, 0.106)
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
