"""Runs without enough disk space, memory, file descriptors or permissions. They end with exit code 1 and one line that
names what was missing, or continue with one warning if only a checkpoint could not be written; none looks finished. Resumed
with sufficient resources, their results are bitwise identical to those of an uninterrupted run."""

import math
import os
import resource
import shutil
import subprocess
import threading

import attack

def with_limit(which, value):
    return lambda: resource.setrlimit(which, (value, value))


def as_plain_user():
    """Words before a command that take a root's power over permissions."""
    return ["setpriv", "--bounding-set=-all", "--inh-caps=-all"] if os.geteuid() == 0 else []


def mount_words():
    """Words before a command that may mount; none: this machine does not let us."""
    words = ["unshare", "--mount"] + ([] if os.geteuid() == 0 else ["--user", "--map-root-user"])
    probe = subprocess.run([*words, "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True)
    return words if probe.returncode == 0 else None


def least(which, most, is_enough):
    """The least limit under which a command succeeds, by bisection to 0.1 % of `most`."""
    low, high = 0, most
    while high - low > max(1, most // 1000):
        middle = (low + high) // 2
        low, high = (low, middle) if is_enough(with_limit(which, middle)) else (middle, high)
    return high


class LimitedRuns:
    # What the short runs may need beside the loaded program, and what differs from one loading to the next, bytes.
    MORE_MEMORY, SPREAD = 35_000_000, 1_500_000

    def __init__(self, attacked):
        self.attack, self.random = attacked, attacked.random
        loads = lambda limit: subprocess.run([attacked.tdbd, "--version"], capture_output=True,
                                             preexec_fn=limit).returncode == 0
        self.least_memory = self.SPREAD + least(resource.RLIMIT_AS, 400_000_000, loads)
        self.least_descriptors = least(resource.RLIMIT_NOFILE, 64, loads)
        self.mount = mount_words()
        self.skipped = set() if self.mount else {"disk: no right to mount one"}
        if shutil.which("setpriv") is None and os.geteuid() == 0:
            self.skipped.add("read-only folder: no setpriv")

    def kinds_of_limits(self):
        limits = [self.file_size, self.memory, self.descriptors]
        if self.mount:
            limits.append(self.disk)
        if as_plain_user() == [] or shutil.which("setpriv"):
            limits.append(self.read_only)
        return limits

    def size(self, kind, share):
        """Up to a share of what the whole run writes: any order of magnitude as likely."""
        most = share * sum(len(b) for b in self.attack.whole(kind)[0].values())
        return int(math.exp(self.random.uniform(math.log(100.0), math.log(most))))

    def run(self, command, **more):
        return subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=600, **more)

    def file_size(self, kind, folder, command):
        bytes_ = self.size(kind, 1.0)
        return f"files of {bytes_} bytes", self.run(command, preexec_fn=with_limit(resource.RLIMIT_FSIZE, bytes_))

    def memory(self, kind, folder, command):
        bytes_ = self.least_memory + self.random.randint(0, self.MORE_MEMORY)
        return f"memory of {bytes_} bytes", self.run(command, preexec_fn=with_limit(resource.RLIMIT_AS, bytes_))

    def descriptors(self, kind, folder, command):
        number = self.least_descriptors + self.random.randint(0, 5)
        return f"{number} descriptors", self.run(command, preexec_fn=with_limit(resource.RLIMIT_NOFILE, number))

    def disk(self, kind, folder, command):
        """The disk is one of memory, over the folder; what is on it in the end is brought back."""
        folder.mkdir(parents=True, exist_ok=True)
        kept = folder.with_name(folder.name + "-disk")
        shutil.rmtree(kept, ignore_errors=True)
        have = sum(p.stat().st_size + 4096 for p in folder.rglob("*") if p.is_file())
        kilobytes = 40 + have // 1024 + self.size(kind, 1.5) // 1024
        script = ('mkdir "$2" && cp -a "$1/." "$2" && mount -t tmpfs -o "size=$3k" tmpfs "$1" && cp -a "$2/." "$1" && '
                  'folder="$1" kept="$2" && shift 3 && { "$@"; code=$?; cp -a "$folder/." "$kept"; '
                  'find "$kept" -mindepth 1 | while IFS= read -r f; do [ -e "$folder${f#"$kept"}" ] || rm -rf "$f"; done; '
                  'exit $code; }')
        done = self.run([*self.mount, "bash", "-c", script, "bash", str(folder), str(kept), str(kilobytes), *command])
        shutil.rmtree(folder)
        kept.rename(folder)
        return f"a disk of {kilobytes} kB", done

    def read_only(self, kind, folder, command):
        """From some moment on no file can be made or renamed in the folder."""
        lock = threading.Timer(self.random.uniform(0.0, self.attack.whole(kind)[1]), close, [folder])
        lock.start()
        done = self.run([*as_plain_user(), *command])
        lock.cancel()
        lock.join()
        open_again(folder)
        return "a folder that became read-only", done

    def check(self, kind, folder, what, done):
        """Whether the run came to its end."""
        lines = [line for line in done.stderr.splitlines() if not line.startswith(attack.WARNING)]
        warnings = done.stderr.count(attack.WARNING)
        is_told = len(lines) == 1 and lines[0].startswith("tdbd: ")
        is_refused = done.returncode == 2 and "tdbd: output folder " in done.stderr  # closed before it began
        if warnings > 1 or not (done.returncode in (0, 1) or is_refused) or is_told == (done.returncode == 0):
            self.attack.fail(f"{kind}, {what}: exit {done.returncode}, {folder}: {done.stderr}")
        if done.returncode == 0:
            return True
        self.attack.check_unfinished(kind, folder, what)
        return False

    def until_done(self, kind, limit):
        """A run with a limit, now and then a second time, and then without."""
        folder = self.attack.folder / f"{kind}-limited"
        self.attack.clear(folder)
        for _ in range(self.random.choice([1, 1, 2])):
            what, done = limit(kind, folder, self.attack.next(kind, folder))
            self.attack.limits += 1
            if self.check(kind, folder, what, done):
                break
        else:
            done = self.run(self.attack.next(kind, folder))
            if done.returncode != 0 or not all(line.startswith(attack.WARNING) for line in done.stderr.splitlines()):
                return self.attack.fail(f"{kind}, after {what}: exit {done.returncode}: {done.stderr}")
        self.attack.check_finished(kind, folder, what)


def close(folder):
    for path in (folder / "frames", folder):
        if path.is_dir():
            path.chmod(0o555)


def open_again(folder):
    for path in (folder, folder / "frames"):
        if path.is_dir():
            path.chmod(0o755)
