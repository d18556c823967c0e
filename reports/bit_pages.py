"""Pages of bits, moving pictures and 3-D pages: one for each run, made again when it changed."""

from importlib.metadata import version
from pathlib import Path

import fingerprint
from fingerprint import Stale

HERE = Path(__file__).parent


class BitPages:
    """Pages NAME.html and their stamps NAME.made.json in a folder."""

    own, kind, suffix = ("bit_page.py", "page_tables.py", "bit_page.html.j2"), "page", ".html"

    def __init__(self, manifest, data, folder):
        self.manifest, self.data, self.folder = manifest, data, Path(folder)

    def groups(self):
        return self.manifest.bit_pages

    def runs(self):
        return [r for group in self.groups() for r in self.manifest.group(group)]

    def page(self, run):
        return self.folder / f"{run.name}{self.suffix}"

    def stamp(self, run):
        return self.folder / f"{run.name}.made.json"

    def inputs(self, run):
        """Fingerprint of all that decides the page: result, scripts, versions."""
        return fingerprint.of_value([
            fingerprint.read(self.data.stamp(run)).get("files"), [fingerprint.of_file(HERE / name) for name in self.own],
            fingerprint.of_scripts(HERE / "figures", *(HERE / name for name in self.own if name.endswith(".py"))), version("matplotlib"), version("numpy")])

    @staticmethod
    def write(folder, path):
        import bit_page  # slow to load, and most calls draw nothing
        bit_page.write(folder, path)

    def is_current(self, run):
        return self.page(run).is_file() and fingerprint.read(self.stamp(run)).get("inputs") == self.inputs(run)

    def update(self, run):
        """Draws a stale page; returns whether it did."""
        if self.is_current(run):
            return False
        self.stamp(run).unlink(missing_ok=True)
        try:
            self.write(self.data.result(run), self.page(run))
        except ValueError as error:
            raise Stale(f"{self.kind} of {run.name}: {error}") from error
        fingerprint.write(self.stamp(run), {"inputs": self.inputs(run)})
        return True

    def demand_current(self, run):
        if not self.is_current(run):
            raise Stale(f"{self.page(run)}: {self.kind} of {run.name}: missing, or its data or scripts changed after it was drawn")


class Animations(BitPages):
    """Moving pictures NAME.gif of holes being drilled."""

    own, kind, suffix = ("animate.py",), "moving picture", ".gif"

    def groups(self):
        return self.manifest.animations

    @staticmethod
    def write(folder, path):
        import animate
        path.parent.mkdir(parents=True, exist_ok=True)
        animate.animate(folder, path)


class Pages3d(BitPages):
    """3-D pages NAME.html of runs with frames; none is made of a run that lacks some."""

    kind = "3-D page"
    own = ("page3d.py", "page3d_pack.py", "page3d_parts.py", "page3d_run.py", "page3d_scene.py", "animate.py",
           *(f"web/{path.name}" for path in sorted((HERE / "web").glob("*"))))

    def groups(self):
        return self.manifest.pages3d

    @staticmethod
    def write(folder, path):
        import page3d
        if missing := page3d.write(folder, path).missing:
            path.unlink()
            raise ValueError(f"found no frame {missing[0]['number']} ({missing[0]['why']}), expected all")
