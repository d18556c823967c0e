#!/usr/bin/python3
"""Makes or measures the studies of reports/studies: questions that were measured once, each with a README, data, and a table or a figure.

    reports/studies.py NAME [--output DIR]      makes table.md and figure.png of a study from its data
    reports/studies.py NAME --measure           measures its data again; requires a release build
        --build DIR       another build (build/release)
        --results DIR     keeps the runs in DIR, and does not repeat runs that DIR contains
        --only FILE ...   measures only these CSV files, or parts that the study's README names

`scripts/report --study NAME` calls this script. study.py reads a study, study_figures.py makes table and figure, study_runs.py measures.
"""

import argparse
import re
import subprocess
import sys
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import system_python

system_python.require("markdown", "matplotlib", "numpy")

import fingerprint
import page_links
from fingerprint import Stale

HERE = Path(__file__).resolve().parent
TIME_LIMIT = 120  # s; a study is made from data, without measurements
STUDY_LEVEL = 2  # of headings on the page of a study
PRODUCTS = ("table.md", "figure.png")
MADE_BY = ("study.py", "study_figures.py", "study_tools.py", "figures/style.py")  # a change of these makes all studies again


@dataclass(frozen=True)
class Shown:
    """The parts of a study that the page shows."""

    name: str
    folder: Path
    title: str
    text: str  # Markdown, without the title


def read(folder):
    """The study in a folder. Raises Stale if README.md or its title is missing, or if both study.toml and study.py are."""
    if not (folder / "README.md").is_file():
        raise Stale(f"study {folder.name}: {folder / 'README.md'} is missing")
    if not any((folder / file).is_file() for file in ("study.toml", "study.py")):
        raise Stale(f"study {folder.name}: {folder / 'study.toml'} is missing")
    title, _, text = (folder / "README.md").read_text(encoding="utf-8").partition("\n")
    if not title.startswith("# "):
        raise Stale(f"study {folder.name}: README.md begins with {title!r}, expected \"# TITLE\"")
    return Shown(folder.name, folder, title[2:].strip(), text)


def find(root):
    """All studies of a project, by name."""
    return [read(f) for f in sorted((Path(root) / "reports/studies").glob("*")) if f.is_dir() and f.name != "__pycache__"]


def as_html(text, level=4):
    """Markdown as HTML, with all headings at one level, and tables that scroll within their boxes."""
    import markdown
    html = markdown.markdown(text, extensions=["tables", "fenced_code"], output_format="html")
    return page_links.in_boxes(re.sub(r"<(/?)h[1-6]>", rf"<\1h{level}>", html))


class Studies:
    """The products of the studies in OUTPUT/NAME, with stamps OUTPUT/NAME.made.json."""

    def __init__(self, root, output):
        self.root, self.output = Path(root), Path(output)

    def runs(self):
        return find(self.root)

    def folder(self, study):
        return self.output / study.name

    def stamp(self, study):
        return self.output / f"{study.name}.made.json"

    def products(self, study):
        """Paths of the table and the figure, if they exist."""
        return [self.folder(study) / p for p in PRODUCTS if (self.folder(study) / p).is_file()]

    def inputs(self, study):
        """Fingerprint of the files of the study and of the scripts that make its tables and figures."""
        files = sorted(f for f in study.folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)
        own = [[str(f.relative_to(study.folder)), fingerprint.of_file(f)] for f in files]
        shared = [fingerprint.of_file(HERE / name) for name in MADE_BY]
        return fingerprint.of_value([own, shared, version("matplotlib"), version("numpy")])

    def is_current(self, study):
        return bool(self.products(study)) and fingerprint.read(self.stamp(study)).get("inputs") == self.inputs(study)

    def call(self, study):
        """Makes table and figure in a separate process. Raises Stale if that fails or writes neither."""
        folder = self.folder(study)
        folder.mkdir(parents=True, exist_ok=True)
        for product in self.products(study):
            product.unlink()
        try:
            done = subprocess.run([sys.executable, "-B", __file__, study.folder, "--output", folder],
                                  capture_output=True, text=True, timeout=TIME_LIMIT, check=False)
        except subprocess.TimeoutExpired as error:
            raise Stale(f"study {study.name}: took more than {TIME_LIMIT} s; expected a study that only reads data") from error
        if done.returncode != 0:
            raise Stale(f"study {study.name}: making failed with exit code {done.returncode}\n{done.stderr.strip()}")
        if not self.products(study):
            raise Stale(f"study {study.name}: made neither {' nor '.join(PRODUCTS)}")

    def update(self, study):
        """Makes the study if it is stale. Returns whether it was made."""
        if self.is_current(study):
            return False
        self.stamp(study).unlink(missing_ok=True)
        self.call(study)
        fingerprint.write(self.stamp(study), {"inputs": self.inputs(study)})
        return True

    def demand_current(self, study):
        if not self.is_current(study):
            raise Stale(f"{self.folder(study)}: study {study.name}: its table or figure is missing, or its files changed after it was made")

    def table(self, study):
        """The table as HTML; empty if there is none."""
        path = self.folder(study) / "table.md"
        return as_html(path.read_text(encoding="utf-8"), STUDY_LEVEL) if path.is_file() else ""

    def figure(self, study):
        """The path of the figure; None if there is none."""
        path = self.folder(study) / "figure.png"
        return path if path.is_file() else None


def make(study, out):
    """Writes OUT/table.md and OUT/figure.png, if the study has a table and a figure."""
    import study_figures
    out.mkdir(parents=True, exist_ok=True)
    study_figures.write_tables(study, out)
    study_figures.write_figure(study, out)


def main(arguments):
    import study as one
    import study_runs
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("study", help="the name of a study, or its folder")
    parser.add_argument("--output", type=Path, help="where table and figure go (results/report/studies/NAME)")
    parser.add_argument("--measure", action="store_true", help="measure the data again")
    parser.add_argument("--build", type=Path, default=HERE.parent / "build/release")
    parser.add_argument("--results", type=Path, help="keep runs in this folder, and do not repeat runs that it contains")
    parser.add_argument("--only", nargs="+", default=(), metavar="FILE", help="measure only these CSV files")
    chosen = parser.parse_args(arguments)
    folder = Path(chosen.study) if Path(chosen.study).is_dir() else HERE / "studies" / chosen.study
    if not folder.is_dir():
        parser.error(f"found no study {chosen.study}, expected one of {', '.join(s.name for s in find(HERE.parent))}")
    try:
        if chosen.measure:
            study_runs.measure(one.load(folder), chosen.build.resolve(), chosen.results, chosen.only)
        out = chosen.output or HERE.parent / "results/report/studies" / folder.name
        make(one.load(folder), out)
    except Stale as error:
        sys.exit(f"studies: {error}")
    if not chosen.output:
        print(f"made {', '.join(str(out / p) for p in PRODUCTS if (out / p).is_file())}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
