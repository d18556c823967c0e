"""Runs tests of one GoogleTest program up to the first failure, each with a limit of processor time."""

import os
import re
import resource
import subprocess
import threading
import time
from dataclasses import dataclass

TICK = os.sysconf("SC_CLK_TCK")
STARTED = re.compile(r"^\[ RUN      \] (\S+)")
FAILED = re.compile(r"^\[  FAILED  \] (\S+?),? ")
ENDED = re.compile(r"^\[==========\] (\d+) tests? from .* ran\.")
MEMORY, FILE_SIZE = 8 << 30, 1 << 30  # bytes: a mutant may ask for anything


@dataclass
class Outcome:
    verdict: str = "passed"  # or failed, crashed, timed out
    test: str = ""  # the one that failed
    ran: int = 0


def limits():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_SIZE, FILE_SIZE))
    os.setsid()


def cpu_seconds(pid):
    """Processor time of a process and of its children that have ended."""
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
            words = file.read().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return sum(int(w) for w in words[11:15]) / TICK


class Reader(threading.Thread):
    """Follows what the program says: which test runs, since when, which failed."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process, self.test, self.failed, self.ran, self.ended = process, "", "", 0, False
        self.since_cpu = self.since_wall = 0.0
        self.begin("")

    def begin(self, test):
        self.since_cpu, self.since_wall, self.test = cpu_seconds(self.process.pid), time.monotonic(), test

    def run(self):
        for line in self.process.stdout:
            if started := STARTED.match(line):
                self.ran += 1
                self.begin(started.group(1))
            elif (failed := FAILED.match(line)) and not self.failed:
                self.failed = failed.group(1)
            elif ENDED.match(line):
                self.ended = True


def is_over(reader, limit_of):
    limit = limit_of(reader.test)
    # A test that waits uses no processor time: four times the limit by the clock, and a minute for a busy machine.
    return (cpu_seconds(reader.process.pid) - reader.since_cpu > limit
            or time.monotonic() - reader.since_wall > 4.0 * limit + 60.0)


def stop(process):
    try:
        os.killpg(process.pid, 9)  # its own group: the programs that it calls go with it
    except ProcessLookupError:
        pass


def run_tests(program, tests, limit_of, environment, folder):
    """Outcome of these tests. limit_of(test): s of processor time. Raises ValueError when no test ran."""
    process = subprocess.Popen([str(program), "--gtest_filter=" + ":".join(tests), "--gtest_fail_fast", "--gtest_color=no"],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace", cwd=folder,
                               env={**os.environ, **environment}, preexec_fn=limits)
    reader = Reader(process)
    reader.start()
    over = False
    while process.poll() is None and not over:
        time.sleep(0.02)
        over = is_over(reader, limit_of)
    stop(process)
    process.wait()
    reader.join(timeout=10.0)
    process.stdout.close()
    if reader.ran == 0 and not over and process.returncode == 0:
        raise ValueError(f"{program}: no test ran of {tests[:3]}")
    if over:
        return Outcome("timed out", reader.test, reader.ran)
    if process.returncode == 0 and reader.ended:
        return Outcome("passed", "", reader.ran)
    return Outcome("failed", reader.failed, reader.ran) if reader.failed else Outcome("crashed", reader.test, reader.ran)
