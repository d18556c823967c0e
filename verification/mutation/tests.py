"""The tests of a program: their names, how long each takes unmutated, and the order in which a mutant meets them."""

import hashlib
import json
import os
import pathlib
import re
import subprocess

from modules import ROOT

TEST = re.compile(r"^\s*(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)\s*,\s*(\w+)", re.MULTILINE)
QUICK = 2.0  # s
# Random tests draw the same numbers each time, so that a verdict can be repeated.
ENVIRONMENT = {"RC_PARAMS": "seed=2007"}


def measured(program, folder):
    """{test: s} of a run of all its tests; every one must pass."""
    report = pathlib.Path(folder) / "seconds.json"
    done = subprocess.run([str(program), f"--gtest_output=json:{report}", "--gtest_color=no"], capture_output=True, text=True, cwd=folder,
                          env={**os.environ, **ENVIRONMENT}, check=False)
    if done.returncode != 0:
        raise ValueError(f"{program}: tests fail without any mutant:\n" + "\n".join(l for l in done.stdout.split("\n") if "FAILED" in l))
    suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
    return {f"{s['name']}.{t['name']}": float(t["time"].rstrip("s")) for s in suites for t in s["testsuite"] if t["result"] == "COMPLETED"}


def baseline(program, cache, folder):
    """{test: s}, measured once for each content of the program."""
    key = hashlib.sha256(program.read_bytes()).hexdigest()
    path = pathlib.Path(cache) / f"seconds-{program.name}.json"
    if path.is_file():
        kept = json.loads(path.read_text(encoding="utf-8"))
        if kept["program"] == key:
            return kept["seconds"]
    seconds = measured(program, folder)
    path.write_text(json.dumps({"program": key, "seconds": seconds}, indent=0), encoding="utf-8")
    return seconds


def limit(seconds):
    return 4.0 * seconds + 15.0


def written_in(files):
    """(suite, name) of the tests of these files."""
    return {pair for f in files for pair in TEST.findall(f.read_text(encoding="utf-8"))}


def own_tests(file):
    """The tests that are written for a source: those of its module in files that include its header."""
    path = pathlib.Path(file)
    header = f'#include "{path.relative_to("src").with_suffix(".hpp")}"'
    return written_in(f for f in (ROOT / "verification" / path.parts[1]).rglob("*_test.cpp") if header in f.read_text(encoding="utf-8"))


def near_tests(file):
    """The tests of the sources in the same folder."""
    return written_in((ROOT / "verification" / pathlib.Path(*pathlib.Path(file).parts[1:-1])).glob("*_test.cpp"))


def is_own(test, own):
    """Whether a listed test, Instance/Suite.name/0 at the most, is one of these."""
    suite, name = test.split(".", 1)
    return any((s, n) in own for s in suite.split("/") for n in [name.split("/")[0]])


class Seconds(dict):
    """{program: {test: s}}, each program measured at its first use; without tests that take longer than `longest`."""

    def __init__(self, build, longest):
        super().__init__()
        self.build, self.longest = build, longest

    def __missing__(self, program):
        seconds = baseline(self.build.program(program), self.build.folder / "mutants", self.build.work)
        self[program] = {test: s for test, s in seconds.items() if s <= self.longest}
        return self[program]


def by_speed(program, names, seconds):
    """The tests in three lots, (program, tests): below a tenth of QUICK, below QUICK, the others."""
    for low, high in ((0.0, 0.1 * QUICK), (0.1 * QUICK, QUICK), (QUICK, float("inf"))):
        chosen = [t for t in names if low <= seconds[program][t] < high]
        if chosen:
            yield high, (program, chosen)


def stages(programs, file, seconds, first=""):
    """(program, tests) in the order of the run: the first one, own tests, those of its folder, the module's other ones, then other programs';
    of each the quick ones first.

    programs: of the module, and others. seconds: {program: {test: s}}. first: "PROGRAM TEST" that killed the mutant before, if it still does.
    """
    homes, others = programs
    program, _, test = first.partition(" ")
    if program in homes + others and test in seconds[program]:
        yield program, [test]
    left = {p: list(seconds[p]) for p in homes}
    for wanted in (own_tests(file), near_tests(file), None):
        of_program = {p: [t for t in left[p] if wanted is None or is_own(t, wanted)] for p in homes}
        left = {p: [t for t in left[p] if t not in of_program[p]] for p in homes}
        lots = [lot for p, names in of_program.items() for lot in by_speed(p, names, seconds)]
        yield from (stage for _, stage in sorted(lots, key=lambda lot: lot[0]))
    for program in others:
        yield from (stage for _, stage in by_speed(program, seconds[program], seconds))
