"""The designers' pages of the report: one for each bit of the manifest, made again when it changed."""

from importlib.metadata import version
from pathlib import Path

import fingerprint
from fingerprint import Stale

HERE = Path(__file__).parent
OWN = ("bit_page.py", "page_tables.py", "bit_page.html.j2")


class BitPages:
    """Pages NAME.html and their stamps NAME.made.json in a folder."""

    def __init__(self, manifest, data, folder):
        self.manifest, self.data, self.folder = manifest, data, Path(folder)

    def runs(self):
        return [r for group in self.manifest.bit_pages for r in self.manifest.group(group)]

    def page(self, run):
        return self.folder / f"{run.name}.html"

    def stamp(self, run):
        return self.folder / f"{run.name}.made.json"

    def inputs(self, run):
        """Fingerprint of all that decides the page: result, scripts, versions."""
        return fingerprint.of_value([
            fingerprint.read(self.data.stamp(run)).get("files"), [fingerprint.of_file(HERE / name) for name in OWN],
            fingerprint.of_scripts(HERE / "figures", HERE / "bit_page.py"), version("matplotlib"), version("numpy")])

    def is_current(self, run):
        return self.page(run).is_file() and fingerprint.read(self.stamp(run)).get("inputs") == self.inputs(run)

    def update(self, run):
        """Draws a stale page; returns whether it did."""
        if self.is_current(run):
            return False
        import bit_page  # slow to load, and most calls draw nothing
        self.stamp(run).unlink(missing_ok=True)
        try:
            bit_page.write(self.data.result(run), self.page(run))
        except ValueError as error:
            raise Stale(f"page of {run.name}: {error}") from error
        fingerprint.write(self.stamp(run), {"inputs": self.inputs(run)})
        return True

    def demand_current(self, run):
        if not self.is_current(run):
            raise Stale(f"page of {run.name}: missing, or its data or scripts changed after it was drawn")
