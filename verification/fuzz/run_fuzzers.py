"""Runs the fuzzers in turn and prints how often each reader was called.

    /usr/bin/python3 verification/fuzz/run_fuzzers.py BUILD [--minutes N] [--only NAME ...] [--table FILE] [--work FOLDER]

BUILD is the folder of the preset fuzz; its build has unpacked the corpus. Each reader is given an equal share of the time. Inputs that
reach new code are written to FOLDER/corpus (default: results/fuzz/corpus), inputs that fail to FOLDER/failures. With --table, executions
and seconds are added to those of FILE. Exit code 1: an input failed; its path is printed.
"""

import argparse
import csv
import os
import pathlib
import re
import subprocess
import sys

import corpus

HERE = pathlib.Path(__file__).resolve().parent
DICTIONARIES = {"toml": {"case", "rotate", "calibration", "bit", "set"}, "tables": {"cutters", "motion", "torque", "records"},
                "meshes": {"stl_text", "stl_binary", "ply_text", "ply_binary", "obj", "off"}, "": {"checkpoint", "archive"}}
# Limits of memory in MiB and of time in s for one input, wide enough for a machine that is busy otherwise.
OPTIONS = ("-rss_limit_mb=1024", "-timeout=30", "-print_final_stats=1", "-print_funcs=0", "-verbosity=0")
# A smaller quarantine of freed memory makes the sanitizer twice as fast.
ENVIRONMENT = {"ASAN_OPTIONS": "malloc_context_size=4:quarantine_size_mb=8"}
COLUMNS = ("reader", "executions", "seconds", "failures")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--only", nargs="+", metavar="NAME")
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path, default=HERE.parents[1] / "results/fuzz")
    parser.add_argument("--longest", type=int, default=4096, help="size limit of an input in bytes (4096)")
    return parser.parse_args()


def readers(chosen):
    """The chosen readers, or all that have a corpus, in the order of their names."""
    known = corpus.readers()
    for name in chosen or ():
        if name not in known:
            sys.exit(f"run_fuzzers: --only: found {name}, expected one of {', '.join(known)}")
    return list(chosen or known)


def words_of(reader):
    name = next(name for name, its in DICTIONARIES.items() if reader in its)
    return [f"-dict={HERE}/dictionaries/{name}.dict"] if name else []


def number_in(log, pattern):
    found = re.findall(pattern, log)
    return int(found[-1]) if found else 0


def fuzz(arguments, reader, seconds):
    """One row of the table. libFuzzer stops at the first input that fails."""
    found, failures = arguments.work / "corpus" / reader, arguments.work / "failures"
    for folder in (found, failures):
        folder.mkdir(parents=True, exist_ok=True)
    programs = arguments.build / "verification/fuzz"
    command = [programs / f"fuzz_{reader}", *OPTIONS, *words_of(reader), f"-max_len={arguments.longest}",
               f"-max_total_time={max(1, round(seconds))}", f"-artifact_prefix={failures}/{reader}-", found, programs / "corpus" / reader]
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace", check=False,
                         env={**os.environ, **ENVIRONMENT})
    if run.returncode != 0:
        print(run.stderr[-4000:])
    return {"reader": reader, "executions": number_in(run.stderr, r"stat::number_of_executed_units: (\d+)"),
            "seconds": round(seconds), "failures": int(run.returncode != 0)}


def add_to(path, rows):
    """Adds the rows to those of the table."""
    sums = {}
    if path.exists():
        with path.open(newline="", encoding="utf-8") as file:
            sums = {row["reader"]: row for row in csv.DictReader(file)}
    for row in rows:
        old = sums.get(row["reader"], {})
        sums[row["reader"]] = {"reader": row["reader"], **{key: int(old.get(key, 0)) + row[key] for key in COLUMNS[1:]}}
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(sums[name] for name in sorted(sums))


def main():
    arguments = parse_arguments()
    names = readers(arguments.only)
    rows = []
    for name in names:
        rows.append(fuzz(arguments, name, 60.0 * arguments.minutes / len(names)))
        print("{reader:12} {executions:12} executions {seconds:6} s {failures} failures".format(**rows[-1]), flush=True)
        if arguments.table:
            add_to(arguments.table, rows[-1:])
    print(f"{'all':12} {sum(row['executions'] for row in rows):12} executions")
    if any(row["failures"] for row in rows):
        print(f"inputs that failed: {arguments.work / 'failures'}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
