#!/usr/bin/python3
"""Run time of a sweep compared with the drilling itself: 64 points of one revolution of bit B, edges of 4 mm.

    benchmarks/sweep.py TDBD [--times 3] [--csv FILE]

Prints a line of JSON: wall seconds of the sweep on two threads, of the same 64 runs' steps alone (their time at one after
another, halved), their ratio; processor seconds of a point over those of its steps. The file gets the same, and what 10^6 points would take.
"""

import argparse
import csv
import json
import resource
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DESIGN = f"""[sweep]
case = "{ROOT}/cases/bit-b-steady.toml"
figures = ["removed_volume_m3"]
[set]
rock.edge_length = "4 mm"
time.revolutions = 1
[[factors]]
key = "motion.rate_of_penetration"
from = "5 m/h"
to = "20 m/h"
count = 64
"""


def used():
    r = resource.getrusage(resource.RUSAGE_CHILDREN)
    return r.ru_utime + r.ru_stime


def swept(tdbd, folder, text, threads):
    """(wall, processor) s of a sweep of this design."""
    design = folder / "design.toml"
    design.write_text(text)
    for old in folder.glob("t*"):
        subprocess.run(["rm", "-rf", old], check=True)
    wall, cpu = time.monotonic(), used()
    subprocess.run([tdbd, "sweep", design, "-o", folder / "t.nc", "--quiet", "--threads", str(threads)], check=True)
    return time.monotonic() - wall, used() - cpu


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", metavar="TDBD")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--csv", type=Path)
    chosen = parser.parse_args()
    short = DESIGN.replace("time.revolutions = 1", 'time.revolutions = 0.002')  # one step: what else a point takes
    walls, points, fixed = [], [], []
    with tempfile.TemporaryDirectory() as name:
        for _ in range(chosen.times):
            wall, cpu = swept(chosen.program, Path(name), DESIGN, 2)
            walls.append(wall)
            points.append(cpu / 64)
            fixed.append(swept(chosen.program, Path(name), short, 2)[1] / 64)
    point, without = statistics.median(points), statistics.median(fixed)
    drilling = 64 * (point - without) / 2
    if chosen.csv:
        hours = 1e6 * point / 3600.0
        with chosen.csv.open("w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows(
                [["64 points on two cores, s", "their steps alone, s", "ratio", "a point, processor s", "before its first step, s",
                  "10^6 points, core hours"],
                 [f"{statistics.median(walls):.2f}", f"{drilling:.2f}", f"{statistics.median(walls) / drilling:.2f}", f"{point:.3f}",
                  f"{without:.3f}", f"{hours:.0f}"]])
    print(json.dumps({"wall_s": statistics.median(walls), "drilling_on_two_cores_s": drilling, "over_drilling": statistics.median(walls) / drilling,
                      "point_processor_s": point, "fixed_processor_s": without}))


if __name__ == "__main__":
    main()
