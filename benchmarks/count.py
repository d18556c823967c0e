#!/usr/bin/python3
"""count.py: instructions of a step, counted by valgrind.

    cmake --preset count && cmake --build --preset count --target instructions
    benchmarks/count.py standard-1.0 drill-bit-b            some workloads; those of rivals if none is named
    benchmarks/count.py metre --warm 48000                  what metre drills, 0.2 m deep
    benchmarks/count.py standard-1.0 --functions 30         the dearest functions, too
    benchmarks/count.py standard-1.0 --set maintenance.every=20 --steps 40
    benchmarks/count.py --phases PHASES.json OUT.csv        by phases: {phase: [functions, with what they call, or "-FUNCTION"]}
    benchmarks/count.py --json OUT.json                     the totals, too, for table.py

Height fields do not start under valgrind: the hulls of their tools need directed rounding. One thread, after a revolution. 20 steps are 4 maintenances of every 5th step. valgrind knows no AVX-512 and counts what the clones for
AVX2 do. "inclusive" counts a function with all that it calls, "self" what is compiled into it, inlined functions among it.
"""

import argparse
import collections
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
WORKLOADS = ["standard-1.0", "standard-1.0-in-turn", "standard-1.0-volumes", "standard-0.7", "standard-0.7-in-turn",
             "standard-0.7-volumes", "drill-bit-b"]
COST = re.compile(r"^[+*-]?\d* \d+$")


def arguments():
    parser = argparse.ArgumentParser(description="Instructions of a step, counted by valgrind.")
    parser.add_argument("workloads", nargs="*", default=WORKLOADS)
    parser.add_argument("--build", type=pathlib.Path, default=HERE.parent / "build/count")
    parser.add_argument("--steps", type=int, default=20)
    parser.add_argument("--warm", type=int, help="steps that are not counted; one revolution if not given")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="a key of the case")
    parser.add_argument("--functions", type=int, default=0, help="how many of the dearest are shown")
    parser.add_argument("--phases", type=pathlib.Path, nargs=2, metavar=("PHASES.json", "OUT.csv"))
    parser.add_argument("--keep", type=pathlib.Path, help="folder for valgrind's files, for callgrind_annotate or KCachegrind")
    parser.add_argument("--json", type=pathlib.Path)
    return parser.parse_args()


def run(workload, wish, folder):
    """valgrind's file of one workload."""
    out = folder / f"callgrind.{workload}"
    options = ["--steps", str(wish.steps)] + [word for s in wish.set for word in ("--set", s)]
    if wish.warm is not None:
        options += ["--warm", str(wish.warm)]
    told = subprocess.run(["valgrind", "--tool=callgrind", "--instr-atstart=no", f"--callgrind-out-file={out}",
                           wish.build / "benchmarks/instructions", workload, *options],
                          capture_output=True, text=True, check=False)
    if told.returncode != 0:
        sys.exit(told.stderr)
    return out


def costs(out):
    """({function: instructions with all that it calls}, {function: its own}) of valgrind's file."""
    names, inclusive, own = {}, collections.Counter(), collections.Counter()
    function = callee = None
    is_call = False

    def name_of(field):
        number, _, name = field.partition(" ")
        if name:
            names[number] = name
        return names[number]

    for line in out.read_text(encoding="utf-8").splitlines():
        key, _, field = line.partition("=")
        if key == "fn":
            function = name_of(field)
        elif key == "cfn":
            callee = name_of(field)
        elif key == "calls":
            is_call = True
        elif COST.match(line):
            cost = int(line.split()[1])
            if not is_call:
                own[function] += cost
            if not is_call or callee != function:
                inclusive[function] += cost
            is_call = False
    return inclusive, own


def short(function):
    """Without the namespaces of TDBD, return type, template's and call's arguments: rock::cut_rock."""
    name = function.replace("(anonymous namespace)::", "").replace("tdbd::", "").replace("tbb::detail::", "")
    name = name.replace("operator()", "call")
    while (less := re.sub(r"<[^<>]*>|\([^()]*\)", "", name)) != name:
        name = less
    return re.sub(r" \[clone (.*)\]", r"\1", name.replace(" const", "")).split(" ")[-1]


def total_of(inclusive):
    """Instructions of the steps that count."""
    return max((n for f, n in inclusive.items() if "counted_steps" in f), default=0)


def show_functions(workload, wish, inclusive, own):
    """The dearest below the step itself."""
    below = [f for f in inclusive if f != "main" and "tdbd::bench::" not in f]
    dearest = sorted(below, key=lambda f: (-inclusive[f], f))[:wish.functions]
    print(f"\n{workload}: thousand instructions a step\n\n| function | inclusive | self |\n|---|---|---|")
    for f in dearest:
        print(f"| `{short(f)}` | {inclusive[f] / wish.steps / 1e3:.0f} | {own[f] / wish.steps / 1e3:.0f} |")


def by_phase(phases, steps, inclusive):
    """{phase: thousand instructions a step}, with what no phase names."""
    of = collections.Counter()
    for f, n in inclusive.items():
        of[short(f)] += n / steps / 1e3
    signed = {phase: [(-1, f[1:]) if f[0] == "-" else (1, f) for f in functions] for phase, functions in phases.items()}
    shares = {phase: sum(sign * of[f] for sign, f in functions) for phase, functions in signed.items()}
    return shares | {"the rest": total_of(inclusive) / steps / 1e3 - sum(shares.values())}


def write_phases(path, shares):
    """A column for each workload."""
    workloads = list(shares)
    with path.open("w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["thousand instructions a step", *workloads])
        for phase in shares[workloads[0]]:
            out.writerow([phase, *(f"{shares[w][phase]:.0f}" for w in workloads)])


def main():
    wish = arguments()
    totals, shares = {}, {}
    phases = json.loads(wish.phases[0].read_text(encoding="utf-8")) if wish.phases else {}
    with tempfile.TemporaryDirectory() as scratch:
        folder = wish.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for workload in wish.workloads:
            out = run(workload, wish, folder)
            inclusive, own = costs(out)
            totals[workload] = round(total_of(inclusive) / wish.steps / 1e6, 3)
            shares[workload] = by_phase(phases, wish.steps, inclusive)
            if wish.functions:
                show_functions(workload, wish, inclusive, own)
    print("\n| workload | million instructions a step |\n|---|---|")
    for workload, million in totals.items():
        print(f"| {workload} | {million:.2f} |")
    if wish.phases:
        write_phases(wish.phases[1], shares)
    if wish.json:
        wish.json.write_text(json.dumps({"million_instructions": totals}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
