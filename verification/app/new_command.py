#!/usr/bin/python3
"""new_command.py TDBD FOLDER: what `tdbd new` writes runs where it stands, and nothing that is there is touched."""

import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
SHORT = {
    "bit": [],
    "pdc": ["--set", "time.revolutions=0.1", "--set", "rock.edge_length=6 mm", "--set", "output.means_from=0.01 s"],
    "cones": ["--set", "time.revolutions=0.02", "--set", "rock.edge_length=6 mm"],
    "drilling": ["--set", "time.duration=20 ms", "--set", "rock.edge_length=6 mm"],
    "top": ["--set", "time.duration=0.1 s"],
    "sweep": ["--points"],
    "calibration": [],
}


def tdbd(*words):
    return subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, timeout=300)


def check(kind):
    """Each file is the shipped one, and the command that is printed runs it."""
    made = tdbd("new", kind, kind)
    assert made.returncode == 0 and made.stderr == "", made
    lines = made.stdout.splitlines()
    if kind == "bit":
        assert lines.pop() == "columns of the table: tdbd keys cutter-table"
    *files, run, keys = lines
    assert keys == "every key: tdbd keys"
    for file in files:
        written, inside = folder / file, pathlib.Path(*pathlib.Path(file).parts[1:])
        shipped = [ROOT / root / inside for root in ("cases", "validation", "cases/bits/new") if (ROOT / root / inside).exists()]
        assert written.read_bytes() == shipped[0].read_bytes().replace(b"\r\n", b"\n"), file
    words = run.split(" it: tdbd ")[1].split()
    done = tdbd(*words, *SHORT[kind])
    assert done.returncode == 0 and (kind != "bit" or done.stderr == ""), (words, done)
    again = tdbd("new", kind, kind)
    assert again.returncode == 2 and "which exists, expected a new folder" in again.stderr, again


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for kind in SHORT:
    check(kind)
(folder / "mine").write_text("mine")
for words, message in ((("new", "cone", "a"), "KIND: found cone, expected cones"), (("new", "rock", "a"), "KIND: found rock, expected one of pdc, bit, cones"),
                       (("new", "top", "mine"), "NAME: found mine, which exists"), (("new", "top"), "found no name, expected one")):
    refused = tdbd(*words)
    assert refused.returncode == 2 and message in refused.stderr, (words, refused)
assert (folder / "mine").read_text() == "mine" and not (folder / "a").exists()
(folder / "empty").mkdir()
assert tdbd("new", "top", "empty").returncode == 0
