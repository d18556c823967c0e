"""The program for browsers as scripts/web built it, its tests' common ground."""

import json
import re
import shutil
import subprocess
import sys

import numpy as np

SKIPPED = 77
NODE = shutil.which("node")
CASES = ("bit-a-steady", "bit-b-whirl", "bit-c-3000psi", "bit-r-rolling", "drill-bit-b")
SHORTER = {"edge_length": '"3 mm"', "revolutions": "1", "duration": '"0.5 s"'}


def commit_of(program):
    """The output of `tdbd --version`."""
    return subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout


def require(program, root, folder):
    """Exits with SKIPPED where there is nothing to test."""
    if not (folder / "tdbd.wasm").is_file() or NODE is None:
        print("skipped: there is no program for browsers (bash scripts/web --test)")
        sys.exit(SKIPPED)
    facts = drilled(root, folder, root / "cases", "bit-b-steady.toml", 0)
    if facts["commit"] not in commit_of(program):
        print(f"skipped: the program for browsers is of {facts['commit']}, this one is not (bash scripts/web --test)")
        sys.exit(SKIPPED)


class Refused(Exception):
    """The message of the program about a case."""


def drilled(root, folder, cases, name, steps, surface="/dev/null"):
    """The last look at a case of a folder after so many steps, under node. Raises Refused."""
    words = [NODE, root / "verification/web/run_case.js", folder / "tdbd.js", cases, name, str(steps), surface]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode == 2:
        raise Refused(done.stderr.strip())
    if done.returncode:
        raise RuntimeError(done.stderr[-2000:])
    return json.loads(done.stdout)


def shortened(root, name):
    """The text of a shipped case with SHORTER in place of its own."""
    text = (root / "cases" / f"{name}.toml").read_text(encoding="utf-8")
    for key, value in SHORTER.items():
        text = re.sub(rf"^{key} = .*$", f"{key} = {value}", text, flags=re.M)
    return text


def surface(path):
    """(points, bytes of the triangles) of a PLY that either program wrote."""
    found = path.read_bytes()
    start = found.index(b"end_header\n") + len(b"end_header\n")
    count = int(re.search(rb"element vertex (\d+)", found).group(1))
    return np.frombuffer(found, "<f8", 3 * count, start).reshape(-1, 3), found[start + 24 * count:]
