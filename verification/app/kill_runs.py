#!/usr/bin/python3
"""kill_runs.py TDBD FOLDER [--kills N] [--limits N] [--minutes M] [--seed K]: kills runs and resumes them.

Short runs of several kinds, on one and two threads, are killed (SIGKILL) at random moments, resumed, killed again, until one finishes; between them, runs that lack disk, memory or descriptors (limited_runs.py). Every
file of a result except timing.json must then be that of an uninterrupted run, and no unfinished run may look finished. Continues until
there were N kills and N runs with each limit, or until M minutes are over. Prints runs, kills, limits, resumes and failures.
"""

import argparse
import pathlib
import subprocess
import sys
import time

import attack
import limited_runs


class KilledRuns:
    def __init__(self, attacked):
        self.attack, self.random = attacked, attacked.random

    def is_killed(self, command, case, seconds):
        """Whether the kill came before the end. Mostly the time counts from when there is something to resume."""
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        waits = self.random.random() < 0.9
        while waits and not case.exists() and process.poll() is None:
            time.sleep(0.001)
        try:
            output, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            self.attack.kills += 1
            return True
        if process.returncode != 0:
            self.attack.fail(f"{' '.join(command)}: exit {process.returncode}: {output.decode()}")
        return False

    def until_done(self, kind):
        """One run, killed now and then."""
        folder, seconds = self.attack.folder / f"{kind}-killed", self.attack.whole(kind)[1]
        self.attack.clear(folder)
        while self.is_killed(self.attack.next(kind, folder), folder / "case.toml", self.random.uniform(0.0, seconds)):
            self.attack.check_unfinished(kind, folder, "a kill")
        self.attack.check_finished(kind, folder, "kills")


def go_round(a, attacked):
    """Kinds in turn: one is killed, and one lacks something."""
    killed, limited = KilledRuns(attacked), limited_runs.LimitedRuns(attacked)
    limits, end = limited.kinds_of_limits(), time.monotonic() + 60.0 * a.minutes
    turn, kinds = 0, list(attack.KINDS)
    while attacked.failures == 0:
        wants_kill, wants_limit = attacked.kills < a.kills, turn < a.limits * len(limits)
        if a.minutes > 0.0:
            wants_kill = wants_limit = time.monotonic() < end
        if not wants_kill and not wants_limit:
            break
        if wants_kill:
            killed.until_done(kinds[turn % len(kinds)])
        if wants_limit and attacked.failures == 0:
            limited.until_done(attacked.random.choice(kinds), limits[turn % len(limits)])
        turn += 1
    for reason in sorted(limited.skipped):
        print("left out:", reason, file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description="Kills runs at random moments and goes on with them.")
    parser.add_argument("tdbd")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--limits", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=0.0)
    parser.add_argument("--seed", type=int, default=2007)
    a = parser.parse_args()
    attacked = attack.Attack(a.tdbd, a.folder, a.seed)
    go_round(a, attacked)
    print(f"{attacked.runs} runs, {attacked.kills} kills, {attacked.limits} limits, {attacked.resumes} resumes, "
          f"{attacked.failures} failures")
    sys.exit(1 if attacked.failures else 0)


if __name__ == "__main__":
    main()
