#!/usr/bin/python3
"""table.py: the tables of benchmarks/README.md, from benchmarks/measured.json and goals.json.

    benchmarks/table.py                      write the tables
    benchmarks/table.py RESULT.json...       first take new figures from results: outputs of programs with Google Benchmark, made
                                             with --benchmark_out=RESULT.json --benchmark_out_format=json; of rivals, metre and
                                             count.py, made with --json RESULT.json; tables of tests, FOLDER/evidence/tables/*.json
    benchmarks/table.py --before RESULT...   the same of an older commit, for the column "before"
    benchmarks/table.py --run build/bench    first run the programs (some minutes) and take their figures
    benchmarks/table.py --check              exit code 1 unless the README contains the tables

measured.json lists what the last table shows: program, benchmark, what one iteration is, which figure to read (cpu_time,
real_time for what times itself, or a counter), its unit, the goal if there is one. What was never measured has no value.
"""

import datetime
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import goals

HERE = pathlib.Path(__file__).resolve().parent
DATA, PAGE = HERE / "measured.json", HERE / "README.md"
MARK = "<!-- table.py: {} {} -->\n"
TOGETHER = ("rivals", "metre")  # run for themselves, not by Google Benchmark
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


def take_benchmarks(measured, found):
    """Puts new results into the entries that they belong to."""
    for entry in measured["benchmarks"]:
        if entry["name"] not in found:
            continue
        row, entry["date"] = found[entry["name"]]
        entry["value"] = float(f"{figure(row, entry):.3g}")
        if "over_ours" in entry:
            entry["over_ours"] = round(row["cgal/tdbd"])
        if "triangles" in row:
            entry["triangles"] = round(row["triangles"])


def rounded(value):
    """Four digits: more are noise."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, list):
        return [rounded(v) for v in value]
    return {k: rounded(v) for k, v in value.items()} if isinstance(value, dict) else value


def take(measured, path):
    """Takes the figures of one file of any program."""
    told = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    if "context" in told:
        return take_benchmarks(measured, results(path))
    date = datetime.date.fromtimestamp(pathlib.Path(path).stat().st_mtime).isoformat()
    if "conditions" in told:
        key = "rivals" if told["threads"] == 1 else f"rivals_{told['threads']}_threads"
        measured[key] = {"date": date} | rounded(told)
    elif "rows" in told:
        rows = told["rows"] if isinstance(told["rows"], list) else [told["rows"]]
        measured[pathlib.Path(path).stem] = rounded(rows)
    else:
        measured.update(rounded(told))
    return None


def run(measured, build):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "result.json"
        for program, options in measured["programs"].items():
            subprocess.run([build / "benchmarks" / program, *options, f"--benchmark_out={out}",
                            "--benchmark_out_format=json"], check=True)
            take(measured, out)
        for program in TOGETHER:
            subprocess.run([build / "benchmarks" / program, "--json", out], check=True)
            take(measured, out)


def remark(entry):
    if "over_ours" in entry:
        return f"{entry['over_ours']} times TDBD in the same run"
    return f"goal: {entry['goal']}" if "goal" in entry else ""


def what(entry):
    """A description of one iteration, with the size of the rock if the program reports it."""
    return f"{entry['what']}, {entry['triangles']} triangles" if "triangles" in entry else entry["what"]


def row(entry):
    value = f"{entry['value']:g} {entry['unit']}" if entry["value"] is not None else "not measured"
    return (f"| `{pathlib.Path(entry['program']).name}` | `{entry['name']}` | {what(entry)} | {value} | {remark(entry)} "
            f"| {entry['date'] or ''} |\n")


def table(measured):
    head = "| program | benchmark | one iteration | CPU time | | measured |\n|---|---|---|---|---|---|\n"
    return head + "".join(map(row, measured["benchmarks"]))


def between(text, name, content):
    """The text with this between the marks of that name."""
    begin, end = MARK.format(name, "begin"), MARK.format(name, "end")
    before, rest = text.split(begin)
    return before + begin + content + end + rest.split(end)[1]


def page(text, measured):
    """The page with the tables between their marks."""
    text = between(text, "goals", goals.goals_table(measured))
    text = between(text, "rivals", goals.rivals_table(measured))
    return between(text, "benchmarks", table(measured))


def main(arguments):
    measured = json.loads(DATA.read_text(encoding="utf-8"))
    text = PAGE.read_text(encoding="utf-8")
    if arguments == ["--check"]:
        sys.exit(0 if page(text, measured) == text else f"{PAGE} does not hold the tables of {DATA}: run benchmarks/table.py")
    first, into = arguments[:1], measured
    if first == ["--run"]:
        run(measured, pathlib.Path(arguments[1]))
        arguments = arguments[2:]
    elif first == ["--before"]:
        into = measured.setdefault("before", {"benchmarks": []})
        arguments = arguments[1:]
    for path in arguments:
        take(into, path)
    DATA.write_text(json.dumps(measured, indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(page(text, measured), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
