"""A project of one run, one figure and one claim, with a program that counts its calls.

The scripts under test are copied into it; they know a project only through its files.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

REPORTS = pathlib.Path(__file__).resolve().parents[2] / "reports"
PROGRAM = """#!/bin/sh
echo "$@" >> "$(dirname "$0")/calls"
[ "$2" = cases/bad.toml ] && { echo "tdbd: bad case" >&2; exit 2; }
while [ "$1" != -o ]; do shift; done
echo '{"version": "0.1", "commit": "abc"}' > "$2/summary.json"
echo 'differs from run to run' > "$2/timing.json"
cp cases/one.toml "$2/copy.toml"
"""
FIGURE = """
from matplotlib.figure import Figure

def draw(inputs):
    figure = Figure(figsize=(2, 2))
    rows = inputs.table("numbers")
    figure.suptitle(f"{inputs.folder('one').name}: {len(rows) if rows is not None else 0} rows")
    return figure
"""
MANIFEST = """
[runs.one]
command = "rotate"
case = "cases/one.toml"
set = {"time.step" = "0.1 s"}
quick = {set = {"time.duration" = "1 s"}}

[[figures]]
name = "first"
script = "first"
thesis = "5.2"
title = "First"
shows = "A line."
reconstructed = "all of it"
runs = ["one"]
tables = ["numbers"]
claims = ["chapter5/order"]
"""
INDEX = "".join(f'[[entries]]\nnumber = "figure 5.{k}"\ntitle = "A <line>"\nknown = "title"\n{rest}\n'
                for k, rest in ((1, 'why = "A photograph."'), (2, "")))
CLAIMS = """
[[claims]]
slug = "chapter5/order"
claim = "Second <order>"
where = "abstract"
"""
EVIDENCE = {"claim": "chapter5/order", "what": "order of the attitude", "measured": 2.0012345678901234,
            "unit": "1", "limit": "2 +- 0.003", "verdict": "holds", "test": "Order.is_two", "program": "verify"}


class Project:
    def __init__(self, root, copy_of=None):
        self.root = pathlib.Path(root)
        self.build = self.root / "build/release"
        self.out = self.root / "results/report"
        if copy_of is None:
            self.fill()
        else:
            shutil.copytree(copy_of, root, dirs_exist_ok=True)  # with the files' times

    def fill(self):
        for folder in ("cases", "reports/figures", "build/release/evidence/tables"):
            (self.root / folder).mkdir(parents=True)
        for script in REPORTS.glob("*.py"):
            shutil.copy(script, self.root / "reports")
        for template in REPORTS.glob("*.j2"):
            shutil.copy(template, self.root / "reports")
        self.write("reports/figures/style.py", "")
        self.write("reports/figures/results.py", "")
        self.write("reports/figures/first.py", FIGURE)
        self.write("reports/manifest.toml", MANIFEST)
        self.write("reports/claims.toml", CLAIMS)
        self.write("reports/thesis_index.toml", INDEX)
        self.write("cases/one.toml", "[time]\nstep = 1.0\n")
        self.write("build/release/tdbd", PROGRAM)
        (self.build / "tdbd").chmod(0o755)
        self.write("build/release/verify", "a test program")
        self.measure(EVIDENCE)
        self.write("build/release/evidence/tables/numbers.json",
                   json.dumps({"test": "T.t", "program": "verify", "rows": [{"h": 1.0}, {"h": 2.0}]}))

    def write(self, file, text):
        path = self.root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def measure(self, evidence, name="what"):
        return self.write(f"build/release/evidence/{evidence['claim']}/{name}.json", json.dumps(evidence))

    def make(self, *arguments):
        """(exit code, what it printed, what it complained about)"""
        own = {k: v for k, v in os.environ.items() if k != "TDBD_EVIDENCE"}
        done = subprocess.run([sys.executable, "-B", self.root / "reports/make.py", *arguments],
                              capture_output=True, text=True, env=own, check=False)
        return done.returncode, done.stdout, done.stderr

    def make_or_complain(self, test, words, arguments=()):
        """What it printed; fails the test unless it complained with all these words, or ended well where there are none."""
        code, made, complaints = self.make(*arguments)
        test.assertNotIn("Traceback", complaints)
        test.assertEqual(code, 1 if words else 0, complaints)
        for word in words:
            test.assertIn(word, complaints)
        return made

    def calls(self):
        log = self.build / "calls"
        return log.read_text().splitlines() if log.exists() else []

    def age(self, file, seconds):
        """Makes a file older (or, when negative, younger)."""
        status = os.stat(self.root / file)
        os.utime(self.root / file, ns=(status.st_atime_ns, status.st_mtime_ns - int(1e9 * seconds)))
