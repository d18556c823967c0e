"""What attacks on runs share: short cases of several kinds, what they write when left alone, and what must not happen."""

import pathlib
import random
import shutil
import subprocess
import sys
import time

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
DRILLED = ["output.checkpoint_every=7", "output.frames_every=25", "rock.edge_length='4 mm'"]
KINDS = {
    "steady": ("run", "bit-b-steady", DRILLED + ["time.revolutions=0.5"]),
    "forces": ("run", "bit-b-3000psi", DRILLED + ["time.revolutions=0.3", "output.history_every=7", "output.means_from=0"]),
    "rolling": ("run", "bit-r-rolling", DRILLED + ["motion.rate_of_penetration='100 m/h'", "time.revolutions=0.1"]),
    "drilling": ("run", "drill-bit-b", DRILLED + ["time.duration='0.2 s'"]),
    "trimmed": ("run", "core", DRILLED + ["time.step='2 ms'", "rock.trim='80 mm'", "rock.wall='120 mm'",
                                          "time.revolutions=0.5", "motion.rate_of_penetration='100 m/h'"]),
    "top": ("rotate", "slow-top", ["output.checkpoint_every=20000", "output.history_every=700", "time.duration=2000",
                                   "integrator.drift=lie-mean", "integrator.order=8"]),
    "cones": ("rotate", "heavy-gyrostat", ["output.checkpoint_every=30000", "time.duration=9000",
                                           "load.damping=[1e-4, 1e-4, 1e-4]"]),
}
WARNING = "tdbd: warning: "


def files_of(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*"))
            if p.is_file() and p.name != "timing.json"}


class Attack:
    """Counts, and the runs that were left alone."""

    def __init__(self, tdbd, folder, seed):
        self.tdbd, self.folder, self.random = tdbd, folder, random.Random(seed)
        self.runs = self.kills = self.limits = self.resumes = self.failures = 0
        self.wholes = {}
        folder.mkdir(parents=True, exist_ok=True)

    def begin(self, kind, folder):
        self.runs += 1
        command, case, settings = KINDS[kind]
        sets = [word for s in settings for word in ("--set", s)]
        return [self.tdbd, command, str(CASES / f"{case}.toml"), "--output", str(folder), "--quiet", *sets]

    def resume(self, kind, folder):
        self.resumes += 1
        command = KINDS[kind][0]
        threads = ["--threads", str(self.random.choice([1, 2]))] if command == "run" else []
        return [self.tdbd, command, "--resume", str(folder), "--quiet", *threads]

    def next(self, kind, folder):
        """Starts a run, or resumes it. A run that has not written its case yet cannot be resumed."""
        if (folder / "case.toml").exists():
            return self.resume(kind, folder)
        self.clear(folder)
        return self.begin(kind, folder)

    def clear(self, folder):
        shutil.rmtree(folder, ignore_errors=True)

    def whole(self, kind):
        """Files and seconds of a run that was left alone."""
        if kind not in self.wholes:
            folder = self.folder / f"{kind}-whole"
            self.clear(folder)
            began = time.monotonic()
            subprocess.run(self.begin(kind, folder), check=True, capture_output=True)
            self.wholes[kind] = files_of(folder), time.monotonic() - began
        return self.wholes[kind]

    def fail(self, text):
        self.failures += 1
        print("failure:", text, file=sys.stderr, flush=True)

    def check_unfinished(self, kind, folder, what):
        """A run that was stopped may not pose as another than the finished one."""
        summary = folder / "summary.json"
        if summary.exists() and summary.read_bytes() != self.whole(kind)[0]["summary.json"]:
            self.fail(f"{kind}, {what}: a run that did not end has a summary in {folder}")

    def check_finished(self, kind, folder, what):
        files, found = self.whole(kind)[0], files_of(folder)
        wrong = sorted(n for n in files.keys() | found.keys() if files.get(n) != found.get(n))
        if wrong:
            self.fail(f"{kind}, {what}: {', '.join(wrong)} in {folder} differ from those of a run that was left alone")
