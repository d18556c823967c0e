#!/usr/bin/python3
"""closed_pipe.py TDBD BIT: a reader that closes its pipe early has read enough. The command still writes its files and returns 0."""

import subprocess
import sys
import tempfile
from pathlib import Path

program, bit = sys.argv[1:]


def through_a_pipe(words, lines):
    """Exit code and standard error of a command of whose output so many lines are read."""
    with subprocess.Popen([program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        for _ in range(lines):
            assert process.stdout.readline()
        process.stdout.close()
        err = process.stderr.read().decode()
    return process.returncode, err


for lines in (0, 1):
    assert (got := through_a_pipe(["keys"], lines)) == (0, ""), got
    with tempfile.TemporaryDirectory() as folder:
        assert (got := through_a_pipe(["bit", bit, "-o", f"{folder}/out"], lines)) == (0, ""), got
        written = {f.name for f in Path(folder, "out").iterdir()}
        assert {"bit.toml", "bit.vtp", "bit.stl"} <= written, written
