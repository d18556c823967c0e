#!/usr/bin/python3
"""What a sweep costs beside the drilling itself: 64 points of one revolution of bit B, edges of 4 mm.

    benchmarks/sweep.py TDBD [--times 3]

Prints a line of JSON: wall seconds of the sweep on two threads, of the same 64 runs' steps alone (their time at one after
another, halved), their ratio; processor seconds of a point over those of its steps.
"""

import argparse
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
    print(json.dumps({"wall_s": statistics.median(walls), "drilling_on_two_cores_s": drilling, "over_drilling": statistics.median(walls) / drilling,
                      "point_processor_s": point, "fixed_processor_s": without}))


if __name__ == "__main__":
    main()
