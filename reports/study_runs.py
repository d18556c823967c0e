"""What measure.py of the studies share: numbers that tests print, written to CSV files."""

import argparse
import csv
import os
import re
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def build_folder(text):
    """The release build that the command line names, or the usual one."""
    parser = argparse.ArgumentParser(description=text.split("\n", maxsplit=1)[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    return parser.parse_args().build


def printed(program, tests):
    """What tests of a program print; what they record goes nowhere."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([program, f"--gtest_filter={tests}"], capture_output=True, text=True, check=False,
                             env=os.environ | {"TDBD_EVIDENCE": folder})
    if run.returncode != 0:
        raise SystemExit(run.stdout + run.stderr)
    return run.stdout


def found(pattern, text):
    """The numbers in the groups of the only place that fits."""
    [numbers] = found_all(pattern, text)
    return numbers


def found_all(pattern, text):
    return [[float(n) for n in place.groups()] for place in re.finditer(pattern, text)]


def write_csv(path, headings, *rows):
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([headings, *rows])
