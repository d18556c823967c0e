#!/usr/bin/python3
"""measure.py [VERIFY_SIMULATION]: the wall that each rule leaves, as the test prints it. Writes walls.csv.

VERIFY_SIMULATION: the tests of src/simulation, of a release build unless another is named.
"""

import csv
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = HERE.parents[2] / "build/release/verification/simulation/verify_simulation"
LINE = re.compile(r'gage_teeth = "(\w+)": (\d+) intersecting pairs, worst quality (\S+)')


def main(program=PROGRAM):
    told = subprocess.run([program, "--gtest_filter=*leave_the_best_wall_along_their_normals"], capture_output=True, text=True, check=True).stdout
    walls = {}
    for rule, pairs, quality in LINE.findall(told):
        walls.setdefault(rule, (pairs, quality))  # the first of each: the last line repeats a rule without maintenance's repairs
    with (HERE / "walls.csv").open("w", newline="", encoding="utf-8") as file:
        rows = [[rule, *wall] for rule, wall in walls.items()]
        csv.writer(file, lineterminator="\n").writerows([["rule", "intersecting pairs", "worst quality"], *rows])


if __name__ == "__main__":
    main(*sys.argv[1:])
