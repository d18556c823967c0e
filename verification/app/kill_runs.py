#!/usr/bin/python3
"""kill_runs.py TDBD FOLDER [--kills N] [--seed K]: kills runs at random moments and goes on with them.

Short runs of several kinds, on one and two threads, are killed (SIGKILL), resumed, killed again, until one comes to its
end. Every file of its result but timing.json must then be that of a run that was left alone, and no killed run may pose as
finished. Prints runs, kills, resumes and failures.
"""

import argparse
import pathlib
import random
import shutil
import subprocess
import sys
import time

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
COMMON = ["output.checkpoint_every=7", "output.frames_every=25", "rock.edge_length='4 mm'"]
KINDS = {
    "steady": ("bit-b-steady", ["time.revolutions=0.5"]),
    "forces": ("bit-b-3000psi", ["time.revolutions=0.3"]),
    "rolling": ("bit-r-rolling", ["motion.rate_of_penetration='100 m/h'", "time.revolutions=0.1"]),
    "drilling": ("drill-bit-b", ["time.duration='0.2 s'"]),
    "trimmed": ("core", ["time.step='2 ms'", "rock.trim='80 mm'", "rock.wall='120 mm'", "time.revolutions=0.5",
                         "motion.rate_of_penetration='100 m/h'"]),
}


def files_of(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*"))
            if p.is_file() and p.name != "timing.json"}


class Attack:
    def __init__(self, tdbd, folder, seed):
        self.tdbd, self.folder, self.random = tdbd, folder, random.Random(seed)
        self.runs = self.kills = self.resumes = self.failures = 0
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)

    def start(self, kind, folder):
        case, settings = KINDS[kind]
        sets = [word for s in settings + COMMON for word in ("--set", s)]
        return [self.tdbd, "run", str(CASES / f"{case}.toml"), "--output", str(folder), "--quiet", *sets]

    def whole(self, kind):
        folder = self.folder / f"{kind}-whole"
        began = time.monotonic()
        subprocess.run(self.start(kind, folder), check=True, capture_output=True)
        self.runs += 1
        return files_of(folder), time.monotonic() - began

    def fail(self, text):
        self.failures += 1
        print("failure:", text, file=sys.stderr)

    def killed(self, command, seconds):
        """Whether the kill came before the end."""
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            output, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            self.kills += 1
            return True
        if process.returncode != 0:
            self.fail(f"{' '.join(command)}: exit {process.returncode}: {output.decode()}")
        return False

    def until_done(self, kind, files, seconds):
        """One run, killed now and then. Before it made its folder there is nothing to resume."""
        folder = self.folder / f"{kind}-killed"
        shutil.rmtree(folder, ignore_errors=True)
        command, self.runs = self.start(kind, folder), self.runs + 1
        while self.killed(command, self.random.uniform(0.0, 1.3 * seconds)):
            if (folder / "summary.json").exists() and files_of(folder)["summary.json"] != files["summary.json"]:
                return self.fail(f"{kind}: a killed run has a summary of its own")
            if not (folder / "case.toml").exists():
                shutil.rmtree(folder, ignore_errors=True)
                continue
            threads = str(self.random.choice([1, 2]))
            command, self.resumes = [self.tdbd, "run", "--resume", str(folder), "--quiet", "--threads", threads], self.resumes + 1
        found = files_of(folder)
        wrong = sorted(n for n in files.keys() | found.keys() if files.get(n) != found.get(n))
        if wrong:
            self.fail(f"{kind}: {', '.join(wrong)} differ from those of a run that was left alone")


def main():
    parser = argparse.ArgumentParser(description="Kills runs at random moments and goes on with them.")
    parser.add_argument("tdbd")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=2007)
    a = parser.parse_args()
    attack = Attack(a.tdbd, a.folder, a.seed)
    whole = {kind: attack.whole(kind) for kind in KINDS}
    while attack.kills < a.kills and attack.failures == 0:
        for kind, (files, seconds) in whole.items():
            attack.until_done(kind, files, seconds)
    print(f"{attack.runs} runs, {attack.kills} kills, {attack.resumes} resumes, {attack.failures} failures")
    sys.exit(1 if attack.failures else 0)


if __name__ == "__main__":
    main()
