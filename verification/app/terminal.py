#!/usr/bin/python3
"""terminal.py TDBD CASES: on a terminal every command that takes its time draws a bar, which is full at the end and then left."""

import os
import pathlib
import pty
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
    assert told, words
    quiet, _ = on_terminal(folder, *words, "--quiet", "--force")
    assert quiet == "", (words, quiet)


with tempfile.TemporaryDirectory() as name:
    (pathlib.Path(name) / "design.toml").write_text(DESIGN)
    top = CASES / "slow-top.toml"
    check(name, "rotate", top, "--set", "time.duration=2", "-o", "top")
    check(name, "converge", top, "--set", "time.duration=2", "--over", "time.step", "--levels", "3", "-o", "orders")
    check(name, "run", CASES / "bit-b-steady.toml", "--set", "rock.edge_length=8 mm", "--set", "time.revolutions=0.01", "-o", "hole")
    check(name, "sweep", "design.toml", "-o", "table.nc")
