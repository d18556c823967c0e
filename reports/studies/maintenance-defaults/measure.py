#!/usr/bin/python3
"""Study behind the defaults of [maintenance]: one table per case, a row per choice (thesis: 4.2.4.3
frequency, 4.2.4.4 quality; reconstructed). Wants a release build with the target long-run.

    measure.py                   every choice in every case, ten minutes and more
    measure.py --cases whirl     cases whose name holds the text
    measure.py --choices flip    choices whose name holds the text

Pairs of triangles that intersect (CGAL), worst quality and the quality that 99 % exceed, volume
that maintenance disturbed over the volume removed, operations a revolution, CPU nanoseconds
of maintenance a touched triangle. choices.csv holds what was kept of the tables.
"""

import argparse
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build/release/verification/long_run/long-run"

CASES = {
    "needle": ("standard-workload", ["rock.edge_length='1.5 mm'", "time.revolutions=6"], 6),
    "whirl": ("bit-b-whirl", ["rock.edge_length='3 mm'", "time.revolutions=25"], 25),
    "rolling": ("bit-r-rolling", ["rock.edge_length='3.5 mm'", "time.revolutions=15"], 15),
    "core": ("core", ["rock.edge_length='3 mm'", "time.revolutions=25"], 25),
}

DEFAULTS = "defaults"
CHOICES = {
    DEFAULTS: [],
    "every 1": ["maintenance.every=1"],
    "every 2": ["maintenance.every=2"],
    "every 10": ["maintenance.every=10"],
    "every 20": ["maintenance.every=20"],
    "flips off": ["maintenance.flip_quality=0"],
    "flips below 0.3": ["maintenance.flip_quality=0.3"],
    "flips below 0.5": ["maintenance.flip_quality=0.5"],
    "flips below 0.7": ["maintenance.flip_quality=0.7"],
    "smoothing below 0.3": ["maintenance.smoothing='tangential'", "maintenance.smooth_quality=0.3"],
    "smoothing below 0.5": ["maintenance.smoothing='tangential'", "maintenance.smooth_quality=0.5"],
    "smoothing, no flips": ["maintenance.flip_quality=0", "maintenance.smoothing='tangential'",
                            "maintenance.smooth_quality=0.5"],
    "worst quality 0.05": ["maintenance.worst_quality=0.05"],
    "worst quality 0.2": ["maintenance.worst_quality=0.2"],
    "edges 0.3 to 1.6": ["maintenance.shortest_edge=0.3"],
    "edges 0.5 to 1.6": ["maintenance.shortest_edge=0.5"],
    "edges 0.4 to 1.4": ["maintenance.longest_edge=1.4"],
}

OPERATIONS = ("bisections", "collapses", "flips", "smoothings", "bluntings")


def run(case, settings):
    command = [str(PROGRAM), str(ROOT / f"cases/{case}.toml"), "--rows", "1"]
    for setting in settings:
        command += ["--set", setting]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode == 2:
        raise SystemExit(result.stderr)
    return result.stdout


def figures(text, revolutions):
    row = next(line for line in text.splitlines() if re.match(r" *\d+ +\d+\.\d\d ", line)).split()
    counts = {name: int(m.group(1)) if (m := re.search(rf"^{name} (\d+)$", text, re.M)) else 0
              for name in OPERATIONS}
    return {"triangles": row[2], "pairs": row[3], "worst": row[4], "1 %": row[5],
            "disturbed": row[6], "ns a triangle": row[9],
            **{name: round(counts[name] / revolutions) for name in OPERATIONS},
            "broken": " ".join(row[10:])}


def table(name, choices):
    case, settings, revolutions = CASES[name]
    print(f"\n{name}: `cases/{case}.toml`, {', '.join(f'`{s}`' for s in settings)}\n")
    head = None
    for choice in choices:
        f = figures(run(case, settings + CHOICES[choice]), revolutions)
        if head is None:
            head = list(f)
            print("| choice | " + " | ".join(head) + " |\n|" + "---|" * (len(head) + 1))
        print(f"| {choice} | " + " | ".join(str(f[key]) for key in head) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", default="")
    parser.add_argument("--choices", default="")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    arguments = parser.parse_args()
    globals()["PROGRAM"] = arguments.program
    for name in CASES:
        if arguments.cases in name:
            table(name, [c for c in CHOICES if arguments.choices in c])


if __name__ == "__main__":
    main()
