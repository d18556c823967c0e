"""scripts/tolerances: measures which share of its tolerance each check of the tests uses (README.md)."""

import argparse
import collections
import concurrent.futures
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import checks

ROOT = pathlib.Path(__file__).resolve().parents[2]
RANDOM = re.compile(r"^\s*(?:RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)\s*,\s*(\w+)", re.MULTILINE)
KINDS = ("tight", "rounding", "bound", "said", "loose")
COUNTED = ("tight", "bound", "said", "rounding", "loose")  # the columns of the study's table
HEADS = ("file", "line", "kind", "times", "share", "observed", "allowed", "words")


def programs(build, words):
    """The test programs of a build, the largest first, since they take longest."""
    found = [p for p in (build / "verification").glob("*/verify_*") if p.is_file() and os.access(p, os.X_OK) and words in p.name]
    if not found:
        raise ValueError(f"{build}: no program of tests with \"{words}\" in its name; bash scripts/tolerances builds them")
    return sorted(found, key=lambda p: -p.stat().st_size)


def random_tests():
    """A filter of the tests whose numbers depend on the seed."""
    found = {f"{suite}.{name}" for f in (ROOT / "verification").rglob("*_test.cpp") for suite, name in RANDOM.findall(f.read_text(encoding="utf-8"))}
    return ":".join(sorted(found))


def observe(program, folder, seed, which):
    """Runs the tests of a program. Raises ValueError if one fails, because its observations are then incomplete."""
    environment = {**os.environ, "TDBD_OBSERVED": str(folder), "RC_PARAMS": f"seed={seed}", "TDBD_EVIDENCE": str(folder / "evidence")}
    done = subprocess.run([str(program), f"--gtest_filter={which}", "--gtest_brief=1"], cwd=folder, env=environment, capture_output=True,
                          text=True, errors="replace", check=False)
    if done.returncode != 0:
        raise ValueError(f"{program.name} with seed {seed}: tests fail:\n{done.stdout[-2000:]}")
    print(f"{program.name}, seed {seed}", flush=True)


def observe_all(build, folder, chosen):
    random = random_tests()
    jobs = [(program, seed, "*" if seed == chosen.seeds[0] else random) for seed in chosen.seeds for program in programs(build, chosen.only)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for job in [pool.submit(observe, program, folder, seed, which) for program, seed, which in jobs]:
            job.result()


def rows_of(found):
    """A row for each check, with its kind."""
    texts, rows = {}, []
    for c in found:
        text = texts.setdefault(c.file, (ROOT / c.file).read_text(encoding="utf-8"))
        rows.append((c.file, c.line, checks.kind(c, text), c.times, f"{c.share:.2g}", f"{c.observed:.2g}", f"{c.allowed:.2g}", c.words))
    return rows


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEADS)
        table.writerows(rows)


def write_counts(path, rows):
    """The number of checks of each kind in each folder of tests."""
    counts = collections.Counter((row[0].split("/")[1], row[2]) for row in rows)
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(("tests of", *COUNTED))
        table.writerows((folder, *(counts[folder, kind] for kind in COUNTED)) for folder in sorted({folder for folder, _ in counts}))


def parse(words):
    parser = argparse.ArgumentParser(prog="scripts/tolerances", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--only", default="", help="programs with this word in their name")
    parser.add_argument("--seeds", type=int, nargs="+", default=[2007, 1, 2, 3], help="of random tests; the first one runs all tests")
    parser.add_argument("--table", type=pathlib.Path, help="CSV file for all checks")
    parser.add_argument("--counts", type=pathlib.Path, help="CSV file for the number of checks of each kind")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/mutate")
    return parser.parse_args(words)


def main(words):
    chosen = parse(words)
    with tempfile.TemporaryDirectory(prefix="tdbd-tolerances-") as folder:
        try:
            observe_all(chosen.build.resolve(), pathlib.Path(folder), chosen)
        except ValueError as wrong:
            print(f"tolerances: {wrong}", file=sys.stderr)
            return 2
        rows = rows_of(checks.read(folder, ROOT))
    if chosen.table:
        write(chosen.table, rows)
    if chosen.counts:
        write_counts(chosen.counts, rows)
    loose = [row for row in rows if row[2] == "loose"]
    for file, line, _, _, share, seen, allowed, text in sorted(loose, key=lambda row: float(row[4])):
        print(f"{file}:{line}: observed {seen}, allowed {allowed}, a share of {share}: {text}")
    counts = collections.Counter(row[2] for row in rows)
    print(f"{len(rows)} checks: " + ", ".join(f"{counts[k]} {k}" for k in KINDS))
    return 1 if loose else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
