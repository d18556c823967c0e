"""Runs the scripts of validation/ for the page: chapter 6 and appendix D in a synthetic laboratory, and comparisons with measurements.

A set is a script with its output folder OUTPUT/NAME and the stamp OUTPUT/NAME.made.json. The script runs again when the
program, a file of validation/ or a bit changed. The program reuses the results of cut runs in the output folder.
"""

import json
import subprocess
import sys
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import fingerprint
from fingerprint import Stale

TIME_LIMIT = 900  # s; without results of cut runs a script takes minutes


@dataclass(frozen=True)
class Set:
    name: str
    title: str
    about: str
    command: str  # printed on the page
    script: str  # relative to validation/
    own: tuple  # patterns of the files of validation/ that it depends on


CHAPTER_6 = Set(
    "chapter6", "Chapter 6 and appendix D: the force law calibrated, and what it predicts",
    "Only the titles of the thesis's tables and figures are available, not their numbers, and no data of a laboratory. Therefore a synthetic "
    "laboratory drills bits A, B and C under a known force law, with noise. The law is fitted to two bits and predicts the third. This shows "
    "what such a calibration can find and how accurate its predictions are. It shows nothing about real rock. Everything in this section "
    "comes from the synthetic laboratory. The counterpart of figure 6.7 is in the section Figures.",
    "validation/chapter6/make.py TDBD OUT", "chapter6/make.py", ("chapter6/*", "blind/*", "cases/lab*.toml"))
MEASURED = Set(
    "measured", "Predictions against measurements",
    "Laws that are calibrated on some measured rows predict others. Their errors are compared with a floor, the smallest error that the "
    "measurements allow. Failures are included, with their reason. The layouts of the bits are assumptions of TDBD. Each comparison states "
    "whether its records are measured or come from a published model.",
    "bash scripts/validate", "validate.py", ("*.py", "*.toml", "data/*/*", "records/*", "bits/*", "cases/*.toml"))


class Calibrations:
    """The sets of a project whose scripts exist. With --quick none is made."""

    def __init__(self, root, build, output, is_quick):
        self.root, self.build, self.output, self.is_quick = Path(root), Path(build), Path(output), is_quick

    def found(self):
        return [s for s in (CHAPTER_6, MEASURED) if (self.root / "validation" / s.script).is_file()]

    def runs(self):
        return [] if self.is_quick else self.found()

    def is_made(self, made):
        return made in self.runs()

    def folder(self, made):
        return self.output / made.name

    def stamp(self, made):
        return self.output / f"{made.name}.made.json"

    def inputs(self, made):
        """Fingerprint of everything that the set depends on: program, scripts, cases, records, bits, style, versions."""
        if not (self.build / "tdbd").is_file():
            raise Stale(f"{made.name}: the program {self.build / 'tdbd'} is not built")
        own = {f for pattern in made.own for f in (self.root / "validation").glob(pattern)}
        common = [*(self.root / "cases/bits").glob("*.toml"), *(self.root / "reports" / n for n in ("figures/style.py", "study_tools.py"))]
        files = sorted(f for f in [*own, *common] if f.is_file())
        return fingerprint.of_value([fingerprint.of_program(self.build, "tdbd"), version("matplotlib"), version("numpy"),
                                     [[str(f.relative_to(self.root)), fingerprint.of_file(f)] for f in files]])

    def products(self, made):
        """The files that the page shows."""
        return [p for i in self.items(made) for p in (i["table"], i["picture"]) if p and p.is_file()]

    def contents(self, made):
        return {p.name: fingerprint.of_file(p) for p in self.products(made)}

    def problem(self, made):
        """Why the set is stale, or None."""
        stamp = fingerprint.read(self.stamp(made))
        if not stamp or not self.products(made):
            return "has not been made"
        if stamp["inputs"] != self.inputs(made):
            return "the program, a case, a record or a script changed after it was made"
        if stamp["files"] != self.contents(made):
            return "a table or figure was changed or removed after it was made"
        return None

    def update(self, made):
        """Makes the set if it is stale. Returns whether it was made."""
        if self.problem(made) is None:
            return False
        self.stamp(made).unlink(missing_ok=True)
        inputs = self.inputs(made)
        self.call(made)
        fingerprint.write(self.stamp(made), {"inputs": inputs, "files": self.contents(made)})
        return True

    def demand_current(self, made):
        if problem := self.problem(made):
            raise Stale(f"{self.folder(made)}: {problem}")

    def call(self, made):
        """Runs the script. Raises Stale when it fails."""
        folder, program = self.folder(made), self.build / "tdbd"
        folder.mkdir(parents=True, exist_ok=True)
        arguments = [program, folder] if made == CHAPTER_6 else ["-o", folder, "--program", program]
        words = [sys.executable, "-B", str(self.root / "validation" / made.script), *map(str, arguments)]
        try:
            done = subprocess.run(words, capture_output=True, text=True, timeout=TIME_LIMIT, check=False)
        except subprocess.TimeoutExpired as error:
            raise Stale(f"{made.name}: took more than {TIME_LIMIT} s: {' '.join(words)}") from error
        if done.returncode != 0:
            raise Stale(f"{made.name}: exit code {done.returncode}: {' '.join(words)}\n{done.stderr.strip()}")

    def items(self, made):
        """The figures and tables to show, in order: kind, name, counterpart, title, caption, table or picture (paths)."""
        if not self.is_made(made):
            return []
        return chapter_items(self.folder(made)) if made == CHAPTER_6 else measured_items(self.folder(made))


def table_text(item):
    """The Markdown of an item's table, without the heading and the caption, which the page formats itself."""
    text = item["table"].read_text(encoding="utf-8")
    return text.split("\n\n", 2)[2] if item["has_head"] else text


def chapter_items(folder):
    """The figures and tables that chapter6/make.py lists."""
    try:
        listed = json.loads((folder / "chapter6.json").read_text(encoding="utf-8"))
    except FileNotFoundError:
        return []
    return [{**i, "has_head": True, "table": folder / f"tables/{i['name']}.md" if i["kind"] == "table" else None,
             "picture": folder / f"figures/{i['name']}.png" if i["kind"] == "figure" else None} for i in listed]


def measured_items(folder):
    """The figures of all comparisons, then their tables."""
    titles = {"comparisons": ("All comparisons", "Mean and rms errors of every comparison and law, and their floors."),
              "pressures": ("Forces over pressure by the published model", "Values of a published model, not measured rows.")}
    common = {"counterpart": "", "has_head": False}
    shown = [{"kind": "figure", "name": n, "title": title, "caption": caption, "table": None, "picture": folder / f"{n}.png", **common}
             for n, (title, caption) in titles.items() if (folder / f"{n}.png").is_file()]
    if (folder / "comparisons.md").is_file():
        shown.append({"kind": "table", "name": "comparisons", "title": "Each comparison with its floor and verdict",
                      "caption": "Errors of predictions: computed over measured.", "table": folder / "comparisons.md", "picture": None, **common})
    return shown
