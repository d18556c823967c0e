"""Runs the programs whose inputs changed, and checks whether results match the manifest."""

import subprocess
from pathlib import Path

import fingerprint
from fingerprint import Stale
from manifest import text

# Files of a result folder that depend on the machine, not on the case.
NOT_DATA = {"timing.json"}


class Data:
    """The results of all runs of a manifest in a folder. Each run has a folder NAME/ and a stamp NAME.made.json."""

    def __init__(self, root, build, folder):
        self.root, self.build, self.folder = Path(root), Path(build), Path(folder)
        self.programs = {}

    def result(self, run):
        return self.folder / run.name

    def stamp(self, run):
        return self.folder / f"{run.name}.made.json"

    def command(self, run):
        """The command line after the name of the program."""
        settings = [f"{key}={text(value)}" for key, value in run.settings.items()]
        first = [run.command] if run.command else []
        return [*first, run.case, *run.arguments, *(w for s in settings for w in ("--set", s))]

    def inputs(self, run):
        """Fingerprint of everything that the result depends on: command line, case, program."""
        if not (self.build / run.program).is_file():
            raise Stale(f"{run.name}: the program {self.build / run.program} is not built")
        if run.program not in self.programs:
            self.programs[run.program] = fingerprint.of_program(self.build, run.program)
        return fingerprint.of_value([self.command(run), self.programs[run.program],
                                     fingerprint.of_case(self.root / run.case)])

    def contents(self, run):
        """Fingerprints of the files of a result."""
        folder = self.result(run)
        files = sorted(f for f in folder.rglob("*") if f.is_file() and f.name not in NOT_DATA)
        return {str(f.relative_to(folder)): fingerprint.of_file(f) for f in files}

    def demand_current(self, run):
        """Raises Stale unless the result exists, is unchanged, and was made from the current inputs."""
        stamp = fingerprint.read(self.stamp(run))
        if not stamp:
            raise Stale(f"{self.result(run)}: has not been run")
        if stamp["inputs"] != self.inputs(run):
            raise Stale(f"{self.result(run)}: the result does not match the manifest: its command, its case or "
                        "the program changed")
        if stamp["files"] != self.contents(run):
            raise Stale(f"{self.result(run)}: the result was changed after the run; remove it and {self.stamp(run)}")

    def update(self, run):
        """Runs the program if the inputs changed. Returns whether it ran. A result that was changed manually is not overwritten and
        remains stale."""
        stamp = fingerprint.read(self.stamp(run))
        inputs = self.inputs(run)
        if stamp.get("inputs") == inputs and self.result(run).is_dir():
            return False
        self.stamp(run).unlink(missing_ok=True)
        self.result(run).mkdir(parents=True, exist_ok=True)
        self.call(run)
        fingerprint.write(self.stamp(run), {"inputs": inputs, "command": self.command(run),
                                            "files": self.contents(run)})
        return True

    def call(self, run):
        """Runs the program, which writes its results to the folder of the run. Raises Stale if it fails."""
        words = [str(self.build / run.program), *self.command(run)]
        if run.output == "folder":
            words += ["-o", str(self.result(run)), "--force", "--quiet"]
        done = subprocess.run(words, cwd=self.root, capture_output=True, text=True)
        if done.returncode != 0:
            raise Stale(f"{run.name}: exit code {done.returncode}: {' '.join(words)}\n{done.stderr.strip()}")
        if run.output == "stdout":
            (self.result(run) / "stdout.txt").write_text(done.stdout, encoding="utf-8")

    def newest(self, run):
        """The time of the last change of the result, ns."""
        return max((self.result(run) / name).stat().st_mtime_ns for name in self.contents(run))
