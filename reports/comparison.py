"""The earlier models of chapter 2 beside the program: runs the protocol, draws its figures, writes its tables.

A run of protocol.toml is made again when its command, its case, a bit or tdbd-compare changed; tables and figures when
a run or their script did. With --quick nothing is made.
"""

import importlib
from importlib.metadata import version
from pathlib import Path

import comparison_results
import comparison_tables
import fingerprint
from calibrations import Set
from data import Data
from drawing import DPI, SCRIPTS
from fingerprint import Stale
from manifest import load, runs_of

PROGRAM = "tdbd-compare"
HERE = Path(__file__).parent
SECTION = Set(
    "comparison", "Chapter 2: the earlier models beside this program",
    "Each model of chapter 2 is written as the dissertation and the open literature describe it, and asked the same: bits A, B and C in one rock, sharp, "
    "linear in the area; bit B rolling in its hole; and a roller cone bit with two rows a cone. Most of their equations could not be found and are reconstructed "
    "(reference/literature). So this compares ideas, such as spokes against a mesh, not the authors' programs. The lines called TDBD are this program's.",
    "tdbd-compare with the runs of reports/protocol.toml", "", ())
# function of figures/compare.py: (title, caption)
FIGURES = {
    "compare_areas": (
        "Area that each cutter cuts",
        "At 3 mm a revolution, over the tip's radius. Below: how each model differs from Warren and Sinor's plane, cutters above 1 mm². Beside the "
        "axis the plane knows no core and no side of a cutter; at the gage cuts are thin."),
    "compare_noise": (
        "Noise of the torque over cost",
        "Bit A at 3 mm a revolution, each rock made finer from left to right: rms deviation of one step's torque over its mean, and CPU time for a simulated second, measured once. "
        "A model without noise is not shown. By crossing: a force acts only in the steps in which its cutter crosses a spoke, as the literature is read; "
        "spread: it counts until the cutter would be at the next spoke, which removes the noise in steady drilling. Our mesh with forces from sections, the default, and from volumes."),
    "compare_rates": ("Rate of penetration over weight", "Drag bits and the roller cone bit, each model at the protocol's rates, or at the reference weight."),
    "compare_cones": ("Speeds of the cones", "Over that of the bit, by model, at the protocol's rates; mean over the cones."),
    "compare_wear": ("Wear flats", "Area of each cutter's flat over its radius after the case's distance, of the models that wear."),
    "compare_spectrum": (
        "The bottom of a whirling bit round a circle of 100 mm",
        "Bit B rolls on its wall: 73 lobes with an orbit of 1.5 mm, 37 with 3 mm. Amplitude of the bottom's waves round the circle. 72 planes, 5 degrees apart, cannot show more than 36."),
}


class ComparisonData(Data):
    """Results of the protocol's runs; bits count, and what their files name."""

    def inputs(self, run):
        bits = sorted(f for f in (self.root / "cases/bits").glob("*") if f.is_file())
        return fingerprint.of_value([super().inputs(run), [[f.name, fingerprint.of_file(f)] for f in bits]])


def protocol(path):
    """The runs of protocol.toml."""
    for group, table in load(path)["runs"].items():
        models = table.pop("models", [])
        arguments = ["--models", ",".join(models)] if models else []
        yield from runs_of(group, {"command": "", "program": PROGRAM, "arguments": arguments} | table, False)


class Comparisons:
    """The section of a project with a protocol; nothing is made for --quick."""

    def __init__(self, root, build, output, is_quick):
        self.root, self.build, self.output, self.is_quick = Path(root), Path(build), Path(output), is_quick
        self.data = ComparisonData(root, build, self.output / "data")
        self.file, self.costs = self.root / "reports/protocol.toml", self.root / "reports" / comparison_results.COSTS
        self.asked = list(protocol(self.file)) if self.file.is_file() else []

    def found(self):
        return [SECTION] if self.asked else []

    def runs(self):
        return [] if self.is_quick else self.found()

    def is_made(self, section):
        return section in self.runs()

    def stamp(self):
        return self.output / "comparison.made.json"

    def picture(self, script):
        return self.output / f"{script}.png"

    def table(self, name):
        return self.output / f"{name}.md"

    def results(self):
        """{group: [(settings, Result)]} of all runs."""
        groups, costs = {}, comparison_results.read_costs(self.costs)
        for run in self.asked:
            result = comparison_results.Result(self.data.result(run), comparison_results.costs_of(costs, run.name, self.costs))
            groups.setdefault(run.group, []).append((run.settings, result))
        return groups

    def inputs(self):
        """Fingerprint of what decides tables and figures."""
        scripts = [SCRIPTS / f"{s}.py" for s in ("compare", "style")]
        own = [HERE / n for n in ("comparison.py", "comparison_results.py", "comparison_tables.py", "study_tools.py")]
        runs = [[r.name, fingerprint.read(self.data.stamp(r))] for r in self.asked]
        own += [self.costs] if self.costs.is_file() else []
        return fingerprint.of_value([runs, fingerprint.of_scripts(SCRIPTS, *scripts), [fingerprint.of_file(f) for f in own], version("matplotlib")])

    def products(self, _section):
        """The files that the page shows."""
        made = [*map(self.picture, FIGURES), *map(self.table, comparison_tables.TABLES)]
        return [p for p in made if p.is_file()]

    def contents(self):
        return {p.name: fingerprint.of_file(p) for p in self.products(SECTION)}

    def problem(self):
        """Why tables and figures are stale, or None."""
        stamp = fingerprint.read(self.stamp())
        if not stamp:
            return "has not been made"
        if stamp["inputs"] != self.inputs():
            return "a run or a script changed after it was made"
        return "a table or figure was changed or removed" if stamp["files"] != self.contents() else None

    def demand_current(self, section):
        for run in self.asked:
            self.data.demand_current(run)
        if problem := self.problem():
            raise Stale(f"{self.output}: {problem}")

    def update(self, _section):
        """Makes what is stale; returns whether anything was."""
        for run in self.asked:
            if self.data.update(run):
                print(f"made comparison/{run.name}", flush=True)
        if self.problem() is None:
            return False
        self.stamp().unlink(missing_ok=True)
        results = self.results()
        for script in FIGURES:
            figure = getattr(importlib.import_module("figures.compare"), script)(results)
            figure.savefig(self.picture(script), dpi=DPI, metadata={"Software": None})
        for name, table in comparison_tables.TABLES.items():
            self.table(name).write_text(table.write(results), encoding="utf-8")
        fingerprint.write(self.stamp(), {"inputs": self.inputs(), "files": self.contents()})
        return True

    def items(self, section):
        """What there is to show, as calibrations.py lists it."""
        if not self.is_made(section):
            return []
        common = {"counterpart": "", "has_head": False}
        tables = [{"kind": "table", "name": name, "title": t.title, "caption": t.caption, "table": self.table(name), "picture": None, **common}
                  for name, t in comparison_tables.TABLES.items()]
        figures = [{"kind": "figure", "name": script, "title": title, "caption": caption, "table": None, "picture": self.picture(script), **common}
                   for script, (title, caption) in FIGURES.items()]
        return [i for i in [*tables[:1], *figures, *tables[1:]] if (i["table"] or i["picture"]).is_file()]
