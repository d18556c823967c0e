#!/usr/bin/python3
"""Processor time of a run in Python compared with the command line: runs in turn, each in a process of its own.

    benchmarks/python_cost.py TDBD PACKAGES [--times 9] [--csv FILE]

TDBD: the program; PACKAGES: the folder that holds the package tdbd. "command" is a whole `tdbd run`, "module" is `tdbd.case` and
`tdbd.run` into a folder, "import" is `import tdbd` with numpy. The ratio is the median over pairs of neighbours.
"""

import argparse
import csv
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CASES = {
    "bit-b-steady, 1 mm": ("bit-b-steady.toml", {"time.revolutions": 6}),
    "drill-bit-b, 2 mm": ("drill-bit-b.toml", {"rock.edge_length": "2 mm", "time.duration": "3 s"}),
}
CHILD = """
import json, sys, time
start = time.process_time()
import tdbd
imported = time.process_time()
case, settings, folder = json.loads(sys.argv[1])
tdbd.run(tdbd.case(case, set=settings), folder)
print(json.dumps({"import": imported - start, "module": time.process_time() - imported}))
"""


def command_seconds(program, case, settings, folder):
    words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "run", case, "-o", folder, "--quiet", *words], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def module_seconds(packages, case, settings, folder):
    told = subprocess.run([sys.executable, "-B", "-c", CHILD, json.dumps([str(case), settings, str(folder)])], check=True,
                          capture_output=True, text=True, env=os.environ | {"PYTHONPATH": str(packages)})
    return json.loads(told.stdout)


def measure(wish, name):
    """A row of the table."""
    file, settings = CASES[name]
    commands, modules = [], []
    with tempfile.TemporaryDirectory() as scratch:
        for i in range(wish.times):
            calls = [lambda f: commands.append(command_seconds(wish.program, ROOT / "cases" / file, settings, f)),
                     lambda f: modules.append(module_seconds(wish.packages, ROOT / "cases" / file, settings, f))]
            for k in (0, 1) if i % 2 == 0 else (1, 0):  # neither is always first
                calls[k](Path(scratch) / f"{i}-{k}")
    ratio = statistics.median(m["module"] / c for c, m in zip(commands, modules))
    return {"case": name, "pairs": wish.times, "command, s": f"{statistics.median(commands):.3f}",
            "module, s": f"{statistics.median(m['module'] for m in modules):.3f}", "module over command": f"{ratio:.4f}",
            "import, s": f"{statistics.median(m['import'] for m in modules):.3f}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", type=Path, metavar="TDBD")
    parser.add_argument("packages", type=Path, metavar="PACKAGES")
    parser.add_argument("--times", type=int, default=9)
    parser.add_argument("--csv", type=argparse.FileType("w"), default=sys.stdout)
    wish = parser.parse_args()
    wish.program, wish.packages = wish.program.resolve(), wish.packages.resolve()
    rows = [measure(wish, name) for name in CASES]
    out = csv.DictWriter(wish.csv, rows[0].keys(), lineterminator="\n")
    out.writeheader()
    out.writerows(rows)


if __name__ == "__main__":
    main()
