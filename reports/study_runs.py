"""Measures a study: starts the programs of a build, and writes their output to the CSV files of the study.

`[measure]` of study.toml lists the measurements that need no code. The others are in measure(m) of study.py, where m is a Measure.

[[measure.runs]]      a run of tdbd for each point of a grid
    file, case        the CSV file; the case, or "grid" if the case is an axis of the grid
    set               {KEY = VALUE} for every run
    grid              [[HEADING, KEY, VALUES, UNIT], ...]; the unit may be left out
    columns           [[HEADING, EXPRESSION, FORMAT], ...]; s is summary.json, h is history.nc
[[measure.printed]]   lines that tests of a test program print
    file, program, tests, pattern      {n} in the pattern is a number; every match is a row
    columns           [[HEADING, FORMAT], ...], one for each group of the pattern
    first             true: only the first row with each value of the first column
    repeat            how often the tests run; the largest rows are used
"""

import hashlib
import itertools
import json
import os
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from study_tools import ROOT, read_text, write_rows

NUMBER = r"([-+]?\d+(?:\.\d+)?)"


def setting(value):
    """A value in the syntax of --set."""
    return json.dumps(value) if isinstance(value, (str, bool)) else str(value)


def set_words(settings):
    return [word for key, value in settings.items() for word in ("--set", f"{key}={setting(value)}")]


def found_all(pattern, text):
    """The numbers in the groups of every match. {n} in the pattern is a number."""
    return [[float(n) for n in place.groups()] for place in re.finditer(pattern.replace("{n}", NUMBER), text)]


def found(pattern, text):
    """The numbers in the groups of the only match."""
    [values] = found_all(pattern, text)
    return values


@dataclass
class Run:
    """A result folder. It is kept with `keep` or --results; otherwise the next run replaces it."""

    folder: Path
    summary: dict
    history: object  # an xarray.Dataset in memory

    def mean(self, name, since):
        """The mean of a variable of the history after the time `since`, s."""
        return float(self.history[name].values[self.history.time.values > since].mean())


class Measure:
    """The argument of measure() of a study.py."""

    def __init__(self, folder, build, temporary, results=None, only=()):
        self.folder, self.build, self.temporary, self.only = Path(folder), Path(build), Path(temporary), only
        self.results = Path(results) if results else None
        self.tdbd = self.build / "tdbd"

    def includes(self, part):
        """Whether a part of the study is measured. --only selects parts; the default is all."""
        return not self.only or part in self.only

    def write(self, file, rows):
        write_rows(self.folder / file, rows)
        print(f"wrote {self.folder / file}", flush=True)

    def write_json(self, file, data):
        (self.folder / file).write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
        print(f"wrote {self.folder / file}", flush=True)

    def replace(self, file, rows, column, order):
        """Replaces the rows that have the same values of a column, and keeps other rows. Rows are sorted by that column in the given order."""
        rows = list(rows)
        measured = {row[column] for row in rows}
        headings, *lines = read_text(self.folder / file)
        kept = [row for row in (dict(zip(headings, line)) for line in lines) if row[column] not in measured]
        self.write(file, sorted(kept + rows, key=lambda row: order.index(row[column])))

    def file(self, name, text):
        """Writes a file to the temporary folder and returns its path."""
        path = self.temporary / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def case(self, text, name="case.toml"):
        return self.file(name, text)

    def place(self, words, case):
        """The folder of a run: a folder of --results that is named by a hash of command and case, or the temporary folder."""
        if self.results is None:
            return self.temporary / "run"
        key = json.dumps([list(map(str, words)), Path(case).read_text(encoding="utf-8")])
        return self.results / hashlib.sha256(key.encode()).hexdigest()[:16]

    def run(self, case, settings=None, command="run", words=(), keep=None):
        """Runs tdbd on a case of the project or a file, unless --results contains the run. Exits with the error message of tdbd if it fails."""
        case = ROOT / case
        options = ["--force", "--quiet", *words, *set_words(settings or {})]
        out = self.temporary / keep if keep else self.place([command, *options], case)
        if not (self.results and (out / "summary.json").is_file()):
            shutil.rmtree(out, ignore_errors=True)
            done = subprocess.run([self.tdbd, command, case, "-o", out, *options], capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise SystemExit(done.stderr)
        return read_run(out)

    def is_valid(self, case, settings):
        """Whether `tdbd check` accepts the settings."""
        return subprocess.run([self.tdbd, "check", ROOT / case, *set_words(settings)], capture_output=True, check=False).returncode == 0

    def output(self, program, *words, codes=(0,)):
        """The output of a program of the build. Evidence that tests record is discarded. Exits with the output for other exit codes."""
        with tempfile.TemporaryDirectory() as evidence:
            done = subprocess.run([self.build / program, *words], capture_output=True, text=True, check=False,
                                  env=os.environ | {"TDBD_EVIDENCE": evidence})
        if done.returncode not in codes:
            raise SystemExit(done.stdout + done.stderr)
        return done.stdout

    def printed(self, program, tests):
        return self.output(program, f"--gtest_filter={tests}")

    def intersecting_pairs(self, surface):
        """Pairs of triangles that intersect, by CGAL."""
        return int(self.output("reference/tools/self-intersections", surface, codes=(0, 1)).split("self-intersecting pairs")[1])


def read_run(folder):
    import xarray
    history = folder / "history.nc"
    data = None
    if history.is_file():
        with xarray.open_dataset(history, decode_times=False) as opened:
            data = opened.load()
    summary = folder / "summary.json"
    return Run(folder, json.loads(summary.read_text(encoding="utf-8")) if summary.is_file() else {}, data)


def rows_of_runs(study, measure, plan):
    """The rows of one `[[measure.runs]]`."""
    axes = plan.get("grid", [])
    for point in itertools.product(*(axis[2] for axis in axes)):
        settings, row = dict(plan.get("set", {})), {}
        case = plan["case"]
        for (heading, key, _, *unit), value in zip(axes, point):
            row[heading] = value
            if key == "case":
                case = f"cases/{value}.toml"
            else:
                settings[key] = f"{value} {unit[0]}" if unit else value
        run = measure.run(case, settings)
        for heading, expression, form in plan["columns"]:
            value = study.value(expression, s=run.summary, h=run.history)
            row[heading] = format(value, form) if form else value
        print(row, flush=True)
        yield row


def rows_of_tests(measure, plan):
    """The rows of one `[[measure.printed]]`."""
    pattern, columns = re.compile(plan["pattern"].replace("{n}", NUMBER)), plan["columns"]
    texts = (measure.printed(f"verification/{plan['program']}", plan["tests"]) for _ in range(plan.get("repeat", 1)))
    matches = max([found.groups() for found in pattern.finditer(text)] for text in texts)
    if not matches:
        raise SystemExit(f"found no match of {plan['pattern']!r} in the output of {plan['program']}")
    if plan.get("first"):
        matches = {groups[0]: groups for groups in reversed(matches)}
        matches = list(reversed(matches.values()))
    return [{heading: format(float(word), form) if form else word for (heading, form), word in zip(columns, groups, strict=True)}
            for groups in matches]


def measure(study, build, results=None, only=()):
    """Measures a study again and writes its data."""
    plan = study.plan.get("measure", {})
    own = study.function("measure")
    if not plan and not own:
        raise SystemExit(f"study {study.name} has no [measure] and no measure(); its README.md describes how it was measured")
    with tempfile.TemporaryDirectory() as temporary:
        m = Measure(study.folder, build, temporary, results, only)
        for entry in plan.get("runs", []):
            if m.includes(entry["file"]):
                m.write(entry["file"], rows_of_runs(study, m, entry))
        for entry in plan.get("printed", []):
            if m.includes(entry["file"]):
                m.write(entry["file"], rows_of_tests(m, entry))
        if own:
            own(m)
