#!/usr/bin/python3
"""table.py: the table of benchmarks/README.md, from benchmarks/measured.json.

    benchmarks/table.py                      write the table
    benchmarks/table.py RESULT.json...       first take new figures from outputs of the programs, made with
                                             --benchmark_out=RESULT.json --benchmark_out_format=json
    benchmarks/table.py --run build/bench    first run the programs, some minutes, and take theirs
    benchmarks/table.py --check              exit 1 unless the README holds the table

measured.json lists what the table shows: program, benchmark, what one iteration is, which figure to read (cpu_time, real_time
for what times itself, or a counter), its unit, the goal if there is one. A benchmark that was never measured has no value.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
DATA, PAGE = HERE / "measured.json", HERE / "README.md"
BEGIN, END = "<!-- table.py: begin -->\n", "<!-- table.py: end -->\n"
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def short(name):
    """A benchmark's name without how it was repeated: step/bit_b_1_mm."""
    return re.sub(r"/(iterations|repeats|manual_time|process_time|real_time)(:\d+)?", "", name)


def results(path):
    """{name: (figures, date)} of an output of Google Benchmark: medians where it has them."""
    told = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    date = told["context"]["date"][:10]
    rows = [r for r in told["benchmarks"] if r.get("aggregate_name", "median") == "median"]
    return {short(r["run_name"]): (r, date) for r in rows}


def figure(row, entry):
    """The figure that an entry of the table reads, in the entry's unit."""
    value = row[entry["read"]]
    is_time = entry["read"] in ("cpu_time", "real_time")
    return value * SECONDS[row["time_unit"]] / SECONDS[entry["unit"]] if is_time else value


def take(measured, found):
    """Puts new results into the entries that they belong to."""
    for entry in measured["benchmarks"]:
        if entry["name"] not in found:
            continue
        row, entry["date"] = found[entry["name"]]
        entry["value"] = float(f"{figure(row, entry):.3g}")
        if "over_ours" in entry:
            entry["over_ours"] = round(row["cgal/tdbd"])


def run(measured, build):
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for program, options in measured["programs"].items():
            out = pathlib.Path(folder) / "result.json"
            subprocess.run([build / "benchmarks" / program, *options, f"--benchmark_out={out}",
                            "--benchmark_out_format=json"], check=True)
            found |= results(out)
    return found


def remark(entry):
    if "over_ours" in entry:
        return f"{entry['over_ours']} times ours beside it"
    return f"goal: {entry['goal']}" if "goal" in entry else ""


def row(entry):
    value = f"{entry['value']:g} {entry['unit']}" if entry["value"] is not None else "not measured"
    return (f"| `{pathlib.Path(entry['program']).name}` | `{entry['name']}` | {entry['what']} | {value} | {remark(entry)} "
            f"| {entry['date'] or ''} |\n")


def table(measured):
    head = "| program | benchmark | one iteration | CPU time | | measured |\n|---|---|---|---|---|---|\n"
    return head + "".join(map(row, measured["benchmarks"]))


def page(text, measured):
    """The page with the table between its marks."""
    before, rest = text.split(BEGIN)
    return before + BEGIN + table(measured) + END + rest.split(END)[1]


def main(arguments):
    measured = json.loads(DATA.read_text(encoding="utf-8"))
    text = PAGE.read_text(encoding="utf-8")
    if arguments == ["--check"]:
        sys.exit(0 if page(text, measured) == text else f"{PAGE} does not hold the table of {DATA}: run benchmarks/table.py")
    if arguments[:1] == ["--run"]:
        take(measured, run(measured, pathlib.Path(arguments[1])))
    for path in arguments if arguments[:1] != ["--run"] else []:
        take(measured, results(path))
    DATA.write_text(json.dumps(measured, indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(page(text, measured), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
