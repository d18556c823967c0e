"""The studies of reports/studies: what was measured once, described in a README, with a table or a figure made from its data.

A study is a folder with README.md (its first line is "# TITLE"), data files, and make.py, which takes an output
folder as its only argument and writes table.md, figure.png, or both there.
"""

import re
import subprocess
import sys
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import markdown
from markupsafe import Markup

import fingerprint
from fingerprint import Stale

TIME_LIMIT = 120  # s: make.py reads data, it measures nothing
PRODUCTS = ("table.md", "figure.png")


@dataclass(frozen=True)
class Study:
    name: str
    folder: Path
    title: str
    text: str  # Markdown, without the title


def read(folder):
    """The study in a folder. Raises Stale when README.md or make.py is missing or the title is."""
    for file in ("README.md", "make.py"):
        if not (folder / file).is_file():
            raise Stale(f"study {folder.name}: {folder / file} is missing")
    title, _, text = (folder / "README.md").read_text(encoding="utf-8").partition("\n")
    if not title.startswith("# "):
        raise Stale(f"study {folder.name}: README.md begins with {title!r}, expected \"# TITLE\"")
    return Study(folder.name, folder, title[2:].strip(), text)


def find(root):
    """All studies of a project, by name."""
    return [read(f) for f in sorted((Path(root) / "reports/studies").glob("*")) if f.is_dir() and f.name != "__pycache__"]


def as_html(text):
    """Markdown as HTML; its headings stand below those of the page."""
    html = markdown.markdown(text, extensions=["tables", "fenced_code"], output_format="html")
    return Markup(re.sub(r"<(/?)h[1-6]>", r"<\1h4>", html))


class Studies:
    """What the studies make, in OUTPUT/NAME, with stamps NAME.made.json beside."""

    def __init__(self, root, output):
        self.root, self.output = Path(root), Path(output)

    def runs(self):
        return find(self.root)

    def folder(self, study):
        return self.output / study.name

    def stamp(self, study):
        return self.output / f"{study.name}.made.json"

    def products(self, study):
        """Paths of the table and the figure, those that exist."""
        return [self.folder(study) / p for p in PRODUCTS if (self.folder(study) / p).is_file()]

    def inputs(self, study):
        """Fingerprint of the study's files, and of what draws them."""
        files = sorted(f for f in study.folder.rglob("*") if f.is_file() and "__pycache__" not in f.parts)
        return fingerprint.of_value([[[str(f.relative_to(study.folder)), fingerprint.of_file(f)] for f in files],
                                     version("matplotlib"), version("numpy")])

    def is_current(self, study):
        return bool(self.products(study)) and fingerprint.read(self.stamp(study)).get("inputs") == self.inputs(study)

    def call(self, study):
        """Runs make.py. Raises Stale when it fails or writes neither table nor figure."""
        folder = self.folder(study)
        folder.mkdir(parents=True, exist_ok=True)
        for product in self.products(study):
            product.unlink()
        try:
            done = subprocess.run([sys.executable, "-B", study.folder / "make.py", folder], capture_output=True, text=True,
                                  timeout=TIME_LIMIT, check=False)
        except subprocess.TimeoutExpired as error:
            raise Stale(f"study {study.name}: make.py took more than {TIME_LIMIT} s; it should only read data") from error
        if done.returncode != 0:
            raise Stale(f"study {study.name}: make.py failed with exit code {done.returncode}\n{done.stderr.strip()}")
        if not self.products(study):
            raise Stale(f"study {study.name}: make.py wrote neither {' nor '.join(PRODUCTS)}")

    def update(self, study):
        """Makes a stale study; returns whether it did."""
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
        """The table as HTML; empty when there is none."""
        path = self.folder(study) / "table.md"
        return as_html(path.read_text(encoding="utf-8")) if path.is_file() else ""

    def figure(self, study):
        """The path of the figure; None when there is none."""
        path = self.folder(study) / "figure.png"
        return path if path.is_file() else None
