"""Draws the figures and writes the tables of the manifest whose inputs changed."""

import hashlib
import importlib
import json
import re
from importlib.metadata import version
from pathlib import Path

import evidence
import fingerprint
from fingerprint import Stale

DPI = 200
SCRIPTS = Path(__file__).parent / "figures"
COMMON = ("results", "style")  # of every figure, whether its script names them or not
SUFFIX = {"png": ".png", "svg": ".svg", "table": ".json"}


class Inputs:
    """The input of the function of a figure: result folders of its runs, rows of its tables, files of its sources."""

    def __init__(self, groups, tables, root, sources):
        self.groups, self.tables, self.root, self.sources = groups, tables, root, sources

    def folder(self, group):
        """The result folder of a run that is no sweep."""
        [(_, folder)] = self.groups[group]
        return folder

    def folders(self):
        """The result folders of all runs, in the figure's order."""
        return [folder for runs in self.groups.values() for _, folder in runs]

    def only_folder(self):
        """The result folder of a figure of one run."""
        [folder] = self.folders()
        return folder

    def sweep(self, group):
        """[(settings, result folder)] of all runs of a group; empty when they were not made."""
        return self.groups[group]

    def table(self, name):
        """Rows of an evidence table; None when there is none in this run (--quick)."""
        return self.tables[name]

    def texts(self):
        """{path below the root: text} of the files that its sources name."""
        return {str(f.relative_to(self.root)): f.read_text(encoding="utf-8") for f in self.sources}


def with_named_clips(svg, figure):
    """Clip paths named after the figure and their place in it: matplotlib names one that is no rectangle after its address."""
    clips = dict.fromkeys(re.findall(r'<clipPath id="(\w+)"', svg))
    names = {clip: f"p{hashlib.sha256(f'{figure} {i}'.encode()).hexdigest()[:10]}" for i, clip in enumerate(clips)}
    return re.sub(r'(<clipPath id="|url\(#)(\w+)', lambda m: m[1] + names.get(m[2], m[2]), svg)


def save(made, path):
    """A matplotlib figure, or a table {"heads": [...], "rows": [[...], ...]}; the file is reproducible."""
    if path.suffix == SUFFIX["table"]:
        path.write_text(json.dumps({"heads": list(made["heads"]), "rows": [list(map(str, row)) for row in made["rows"]]}, indent=1) + "\n",
                        encoding="utf-8")
    elif path.suffix == SUFFIX["svg"]:
        import matplotlib
        with matplotlib.rc_context({"svg.hashsalt": "tdbd"}):
            made.savefig(path, metadata={"Date": None, "Creator": None})
        path.write_text(with_named_clips(path.read_text(encoding="utf-8"), path.name), encoding="utf-8")
    else:
        made.savefig(path, dpi=DPI, metadata={"Software": None})


class Drawing:
    """Figures NAME.png or NAME.svg, tables NAME.json, and their stamps NAME.made.json in a folder."""

    def __init__(self, manifest, data, evidence_folder, folder, is_quick):
        self.manifest, self.data, self.is_quick = manifest, data, is_quick
        self.evidence_folder, self.folder = Path(evidence_folder), Path(folder)

    def picture(self, figure):
        return self.folder / f"{figure.name}{SUFFIX[figure.form]}"

    def sources(self, figure):
        """The files of the project that it is drawn from. Raises Stale when a pattern finds none."""
        found = {pattern: sorted(f for f in self.data.root.glob(pattern) if f.is_file()) for pattern in figure.sources}
        for pattern, files in found.items():
            if not files:
                raise Stale(f"figure {figure.name}: its source {pattern} names no file")
        return sorted({f for files in found.values() for f in files})

    def stamp(self, figure):
        return self.folder / f"{figure.name}.made.json"

    def runs(self, figure):
        return [r for group in figure.runs for r in self.manifest.group(group)]

    def is_made(self, run):
        """In a quick run a twin that is not built leaves its part of a figure empty."""
        return not self.is_quick or (self.data.build / run.program).is_file()

    def table(self, name):
        """An evidence table; None when a quick run has none."""
        try:
            return evidence.table(self.evidence_folder, self.data.build, name)
        except Stale:
            if self.is_quick:
                return None
            raise

    def rows(self, name):
        table = self.table(name)
        return table and table["rows"]

    def inputs(self, figure):
        """Fingerprint of all that decides the picture: script, style, results, tables, sources, versions."""
        scripts = fingerprint.of_scripts(SCRIPTS, *(SCRIPTS / f"{n}.py" for n in (figure.script.partition(".")[0], *COMMON)))
        results = [fingerprint.read(self.data.stamp(r)).get("files") for r in self.runs(figure)]
        files = [[str(f.relative_to(self.data.root)), fingerprint.of_file(f)] for f in self.sources(figure)]
        return fingerprint.of_value([scripts, results, [self.rows(t) for t in figure.tables], files, figure.form,
                                     version("matplotlib"), version("numpy")])

    def draw(self, figure):
        import matplotlib  # slow to load, and most calls draw nothing
        matplotlib.use("Agg")
        groups = {g: [(r.settings, self.data.result(r)) for r in self.manifest.group(g) if self.is_made(r)]
                  for g in figure.runs}
        module, _, name = figure.script.partition(".")
        function = getattr(importlib.import_module(f"figures.{module}"), name or ("table" if figure.form == "table" else "draw"))
        given = Inputs(groups, {t: self.rows(t) for t in figure.tables}, self.data.root, self.sources(figure))
        try:
            made = function(given)
        except (ArithmeticError, LookupError, OSError, ValueError) as error:
            raise Stale(f"figure {figure.name}: cannot be drawn of its data: {error!r}") from error
        self.folder.mkdir(parents=True, exist_ok=True)
        save(made, self.picture(figure))

    def problem(self, figure):
        """Why the picture is stale: missing, of other inputs, or older than its data. Or None."""
        picture, stamp = self.picture(figure), fingerprint.read(self.stamp(figure))
        if not picture.is_file() or not stamp:
            return "has not been drawn"
        if stamp["inputs"] != self.inputs(figure):
            return "its data, its script or its style changed after it was drawn"
        for run in filter(self.is_made, self.runs(figure)):
            if self.data.newest(run) > picture.stat().st_mtime_ns:
                return f"older than its data {self.data.result(run)}"
        return None

    def update(self, figure):
        """Draws a stale figure; returns whether it did."""
        if self.problem(figure) is None:
            return False
        self.stamp(figure).unlink(missing_ok=True)
        self.draw(figure)
        fingerprint.write(self.stamp(figure), {"inputs": self.inputs(figure)})
        return True

    def demand_current(self, figure):
        if problem := self.problem(figure):
            raise Stale(f"{self.picture(figure)}: figure {figure.name}: {problem}")
