"""Runs tests of one GoogleTest program up to the first failure, each with a limit of processor time."""

import os
import pathlib
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
MEMORY, FILE_SIZE = 8 << 30, 1 << 30  # bytes: a mutant may allocate or write without limit
IDLE = 120.0  # s without any processor time, after which a test counts as blocked


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


def stat_of(entry):
    """The words of a process's stat after its name; none if it has gone."""
    try:
        return (pathlib.Path("/proc") / entry / "stat").read_text(encoding="ascii", errors="replace").rsplit(")", 1)[1].split()
    except OSError:
        return []


def cpu_seconds(leader):
    """Processor time of a process, of those in its group, and of their children that have ended."""
    stats = [stat_of(entry) for entry in os.listdir("/proc") if entry.isdigit()]
    return sum(int(word) for words in stats if words and words[2] == str(leader) for word in words[11:15]) / TICK


class Reader(threading.Thread):
    """Reads the output of the program: which test runs, since when, which failed."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process, self.test, self.failed, self.ran, self.ended = process, "", "", 0, False
        self.since_cpu = 0.0

    def begin(self, test):
        self.since_cpu, self.test = cpu_seconds(self.process.pid), test

    def run(self):
        for line in self.process.stdout:
            if started := STARTED.match(line):
                self.ran += 1
                self.begin(started.group(1))
            elif (failed := FAILED.match(line)) and not self.failed:
                self.failed = failed.group(1)
            elif ENDED.match(line):
                self.ended = True


class Watch:
    """Whether the test that runs has used up its processor time, or has used none for long."""

    def __init__(self, reader, limit_of):
        self.reader, self.limit_of = reader, limit_of
        self.seen, self.since = -1.0, time.monotonic()

    def is_over(self):
        cpu = cpu_seconds(self.reader.process.pid)
        if cpu != self.seen:
            self.seen, self.since = cpu, time.monotonic()
        return cpu - self.reader.since_cpu > self.limit_of(self.reader.test) or time.monotonic() - self.since > IDLE


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
    watch, over, pause = Watch(reader, limit_of), False, 0.01
    while process.poll() is None and not over:
        time.sleep(pause)
        pause = min(1.2 * pause, 0.5)
        over = watch.is_over()
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
