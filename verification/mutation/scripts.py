"""Tests of the program tdbd that are Python scripts: NAME.py PROGRAM, and behind it an INPUT or a new FOLDER for some. Mutants of the module app meet
them, and those of sweep the one of the command sweep."""

import functools
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

from modules import ROOT
from watch import Outcome

# As in the CMakeLists.txt of these modules; without those that kill or limit runs on purpose, which take minutes.
INPUTS = {"bit_command": "cases/bits/bit-b.toml", "closed_pipe": "cases/bits/bit-b.toml", "cone_command": "cases/bits/bit-r.toml",
          "mesh_command": "cases/bits/bit-b.toml", "terminal": "cases"}
WRITE = ("new_command", "sweep_command")
PRINTED = ("completion_test", "manual_test")  # of what the program prints
NAMES = sorted((*INPUTS, *WRITE, *PRINTED))


def of_file(file, first=""):
    """(the scripts that are written for a source, the others); none for modules but app and sweep. One that killed the mutant before, "verify_app
    NAME.py", counts as its own."""
    killer = first.removeprefix("verify_app ").removesuffix(".py")
    if file.startswith("src/sweep/"):
        return ([killer], []) if killer == "sweep_command" else ([], ["sweep_command"])
    if not file.startswith("src/app/"):
        return [], []
    own = [name for name in NAMES if name == killer or name.removesuffix("_test") == pathlib.Path(file).stem]
    own.sort(key=lambda name: name != killer)
    return own, [name for name in NAMES if name not in own]


def path_of(name):
    return ROOT / "verification" / ("sweep/app" if name == "sweep_command" else "app") / f"{name}.py"


def words(name, program, folder):
    """The script's command; what it writes is below this folder."""
    given = [] if name in PRINTED else [str(pathlib.Path(folder) / name if name in WRITE else ROOT / INPUTS[name])]
    return [sys.executable, "-B", str(path_of(name)), str(program), *given]


def run(name, program, folder, limit):
    """Outcome of a script with this program; limit: s."""
    process = subprocess.Popen(words(name, program, folder), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True)
    try:
        code = process.wait(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return Outcome("timed out", f"{name}.py", 1)
    return Outcome("passed" if code == 0 else "failed", "" if code == 0 else f"{name}.py", 1)


@functools.cache
def limits(build):
    """{script: s} it may take: ten times what it takes unmutated, and a minute. Each must pass."""
    program, found = build.program("tdbd"), {}
    key, path = hashlib.sha256(program.read_bytes()).hexdigest(), build.folder / "mutants/seconds-scripts.json"
    if path.is_file() and (kept := json.loads(path.read_text(encoding="utf-8")))["program"] == key:
        found = kept["seconds"]
    for name in set(NAMES) - found.keys():
        started = time.monotonic()
        if run(name, program, build.work, 600.0).verdict != "passed":
            raise ValueError(f"{path_of(name)}: fails without any mutant")
        found[name] = time.monotonic() - started
    path.write_text(json.dumps({"program": key, "seconds": found}), encoding="utf-8")
    return {name: 10.0 * s + 60.0 for name, s in found.items()}
