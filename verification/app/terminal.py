#!/usr/bin/python3
"""terminal.py TDBD CASES: on a terminal every command that takes its time draws a bar, which is full at the end and then left."""

import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile

PROGRAM, CASES = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
FULL = "\r[" + 24 * "#" + "] 100 %  step "
DESIGN = f"""[sweep]
case = "{CASES}/slow-top.toml"
command = "rotate"
figures = ["steps"]
[set]
time.duration = 2
[[factors]]
key = "time.step"
values = [0.5, 1.0]
"""
LABORATORY = """[laboratory]
law = "hanson-hansen"
pressures = ["3000 psi"]
rates = ["10 m/h", "20 m/h", "30 m/h"]
rotary_speed = "120 rpm"
[truth]
A1 = 1.3
A3 = "22 deg"
A5 = 1.4
A6 = 0.4
"""
CALIBRATION = """[calibration]
law = "hanson-hansen"
records = "lab.csv"
fit_bits = ["B", "C"]
[unknowns.A1]
start = 1.0
[fixed]
A3 = "22 deg"
A5 = 1.4
A6 = 0.4
"""
BIT = f"""[bits]
B = "{CASES}/bits/bit-b.toml"
C = "{CASES}/bits/bit-c.toml"
[rock]
material = "mancos-shale"
edge_length = "8 mm"
[time]
revolutions = 2
steps_per_revolution = 40
[noise]
reading = 0.03
"""


def on_terminal(folder, *words):
    """What the command shows on a terminal, to which standard error goes alone."""
    ours, its = pty.openpty()
    with subprocess.Popen([PROGRAM, *map(str, words)], cwd=folder, stdout=subprocess.PIPE, stderr=its) as process:
        os.close(its)
        shown = b""
        try:
            while some := os.read(ours, 4096):
                shown += some
        except OSError:  # the program has closed its end
            pass
        told = process.stdout.read().decode()
    os.close(ours)
    assert process.returncode == 0, (words, shown)
    return shown.decode(), told


def check(folder, *words):
    """One line, drawn again and again over itself, that ends where the bar is full."""
    shown, told = on_terminal(folder, *words)
    assert shown.startswith("\r[") and shown.count("\n") == 1 and shown.endswith("\r\n"), (words, shown)
    last = shown[shown.rindex("\r["):]
    assert last.startswith(FULL), (words, shown)
    steps = [tuple(map(int, pair)) for pair in re.findall(r" step ([0-9]+) of ([0-9]+) ", shown)]
    assert steps == sorted(steps) and all(done <= total for done, total in steps), (words, steps)
    assert told, words
    quiet, _ = on_terminal(folder, *words, "--quiet", "--force")
    assert quiet == "", (words, quiet)


with tempfile.TemporaryDirectory() as name:
    (pathlib.Path(name) / "design.toml").write_text(DESIGN)
    (pathlib.Path(name) / "lab.toml").write_text(LABORATORY + BIT)
    (pathlib.Path(name) / "fit.toml").write_text(CALIBRATION + BIT)
    top = CASES / "slow-top.toml"
    check(name, "rotate", top, "--set", "time.duration=2", "-o", "top")
    check(name, "converge", top, "--set", "time.duration=2", "--over", "time.step", "--levels", "3", "-o", "orders")
    check(name, "run", CASES / "bit-b-steady.toml", "--set", "rock.edge_length=4 mm", "--set", "time.revolutions=12", "-o", "hole")  # a second: several draws
    check(name, "sweep", "design.toml", "-o", "table.nc")
    on_terminal(name, "laboratory", "lab.toml", "-o", "lab.csv")
    check(name, "calibrate", "fit.toml", "--cuts", "others", "-o", "fit")
