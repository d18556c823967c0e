#!/usr/bin/python3
"""The coupled run and its twins: runs the tests of verification/simulation/coupled and writes what they compare to
coupled-twin.csv beside itself; two minutes, wants a release build with the target verify_coupled_twin.

    measure.py
    measure.py --program PROGRAM     another build's verify_coupled_twin
"""

import argparse
import csv
import pathlib
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PROGRAM = ROOT / "build/release/verification/simulation/verify_coupled_twin"
COLUMNS = ["situation", "quantity", "program", "uncertainty", "twin", "uncertainty of the twin", "difference",
           "combined uncertainty over the scale"]


def rows_of(lines):
    """Each row below the test that wrote it."""
    test = ""
    for line in lines:
        if line.startswith("[ RUN      ]"):
            test = line.split("] ")[1].split(".")[1].replace("_", " ")
        if line.startswith("row;"):
            quantity, program, own, twin, others, difference, scale = line.split(";")[1:]
            combined = (float(own) + float(others)) / float(scale)
            yield [test, quantity, program, own, twin, others, difference, f"{combined:.2g}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=PROGRAM)
    program = parser.parse_args().program
    run = subprocess.run([program], capture_output=True, text=True, check=False)
    with (HERE / "coupled-twin.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows_of(run.stdout.splitlines()))
    return run.returncode


if __name__ == "__main__":
    raise SystemExit(main())
