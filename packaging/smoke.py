#!/usr/bin/python3
"""Tests the packages that scripts/package made, and prints how long each step took and how large each package is.

    packaging/smoke.py FOLDER VERSION

- The Debian package is installed with its dependencies into a fresh minimal Debian 12 (mmdebstrap), which needs root and
  a mirror. Otherwise it is unpacked into an empty folder and its program runs from there; the output states which of the two
  was done. Then it drills the first hole and draws it.
- The wheel is installed into a virtual environment without a compiler on the PATH. It runs a short script and the
  notebooks, whose outputs must be those that they contain. In the fresh Debian it also runs with numpy as the only package.
"""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

NAME = "package"
TIME_OF_FIRST_HOLE, SIZE_OF_WHEEL = 120, 30e6  # s and bytes, at most
# The first hole of docs/start/first-hole.md.
HOLE = ["run", "cases/bit-b-steady.toml", "-o", "first", "--quiet", "--set", "time.revolutions=2", "--set", "motion.rate_of_penetration=10 m/h",
        "--set", "rock.edge_length=3 mm", "--set", "output.frames_every=50"]
SHORT = ["--set", "rock.edge_length=8 mm", "--set", "time.duration=0.2 s"]
SCRIPT = """
import sys, tdbd
assert tdbd.__version__ == sys.argv[1], tdbd.__version__
result = tdbd.run(tdbd.case(sys.argv[2], rock__edge_length="8 mm", time__revolutions=0.2))
assert result.summary["removed_volume_m3"] > 0 and len(result.rock.vertices) > 100
print("tdbd", tdbd.__version__, "from", tdbd.__path__[0])
"""
NOTEBOOKS = """
import sys, json, importlib.util, pathlib
folder = pathlib.Path(sys.argv[1])
loader = importlib.util.spec_from_file_location("execute", folder / "execute.py")
execute = importlib.util.module_from_spec(loader)
loader.loader.exec_module(execute)
paths = sorted(folder.glob("*.ipynb"))
assert paths
for path in paths:
    stored, now = ([cell for cell in book["cells"] if cell["cell_type"] == "code"]
                   for book in (json.loads(path.read_text(encoding="utf-8")), execute.executed(path)))
    for old, new in zip(stored, now, strict=True):
        if not execute.varies(old) and execute.texts(old) != execute.texts(new):
            sys.exit(f"{path.name}: found the output {execute.texts(new)}, expected {execute.texts(old)}")
print(len(paths), "notebooks")
"""


def say(text):
    print(f"{NAME}: {text}", flush=True)


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{NAME}: exit code {done.returncode} of {' '.join(map(str, words))}\n{done.stdout[-3000:]}")
    return done.stdout


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(what, *words, **options):
    """Runs a command; prints and returns the seconds, and those of the processor, which do not depend on other work of the machine."""
    started, used = time.monotonic(), processor_time()
    run(*words, **options)
    seconds, used = time.monotonic() - started, processor_time() - used
    say(f"{what}: {seconds:.1f} s, of the processor {used:.1f} s")
    return seconds, used


def make_debian(root):
    """A minimal Debian 12 in the folder; returns why there is none."""
    if os.geteuid() != 0:
        return "only root can"
    if shutil.which("mmdebstrap") is None:
        return "mmdebstrap is not installed (bash scripts/setup package)"
    done = subprocess.run(["mmdebstrap", "--quiet", "--variant=minbase", "bookworm", root], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return f"mmdebstrap failed: {done.stderr.strip().splitlines()[-1:]}"
    shutil.copy("/etc/resolv.conf", root / "etc/resolv.conf")
    # As in the Debian images of containers: packages are unpacked without waiting for the disk.
    (root / "etc/dpkg/dpkg.cfg.d/unsafe-io").write_text("force-unsafe-io\n", encoding="utf-8")
    return ""


def inside(root, text):
    """A command of the shell in the Debian of that folder, with its own /proc and the devices of this machine."""
    mounted = f"mount -t proc proc {root}/proc && mount --bind /dev {root}/dev && exec chroot {root} /bin/sh -ec \"$0\""
    return ["unshare", "--mount", "sh", "-c", mounted, "export HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive; cd /root; " + text]


def test_wheel_in_debian(root, wheel, version):
    """The wheel beside Debian's Python and numpy, and no other library."""
    for file in (wheel, Path(__file__).resolve().parents[1] / "cases"):
        run("cp", "-r", file, root / "root")
    (root / "root/script.py").write_text(SCRIPT, encoding="utf-8")
    install = "apt-get -qq update; apt-get -qq install -y --no-install-recommends"
    timed("fresh Debian 12: python3, python3-venv and python3-numpy are installed", *inside(root, f"{install} python3 python3-venv python3-numpy"))
    timed("fresh Debian 12: the wheel is installed", *inside(
        root, f"for word in cc gcc c++; do if command -v $word; then exit 1; fi; done; python3 -m venv --system-site-packages venv; venv/bin/pip install -q --no-index --no-deps {wheel.name}"))
    timed("fresh Debian 12: a script runs with the wheel", *inside(root, f"venv/bin/python script.py {version} cases/bit-b-steady.toml"))


def test_deb_in_debian(root, deb, version):
    shutil.copy(deb, root / "tmp" / deb.name)
    install = "apt-get -qq update; apt-get -qq install -y --no-install-recommends"
    times = [timed("fresh Debian 12: the Debian package and its dependencies are installed", *inside(root, f"{install} /tmp/{deb.name}"))]
    hole = " ".join(f"'{word}'" for word in HOLE)
    drawn = "tdbd draw first; tdbd page first; test -s first/bottom_hole.png; test -s first/result.html"
    times.append(timed("fresh Debian 12: the first hole is drilled and drawn", *inside(
        root, f"cp -r /usr/share/tdbd/cases .; tdbd {hole}; {drawn}")))
    seconds, used = (sum(column) for column in zip(*times))
    say(f"first hole from the Debian package on a bare machine: {seconds:.0f} s, of the processor {used:.0f} s; at most {TIME_OF_FIRST_HOLE} s are wanted")
    if used > TIME_OF_FIRST_HOLE:
        sys.exit(f"{NAME}: the first hole took {used:.0f} s of the processor, expected at most {TIME_OF_FIRST_HOLE} s")
    short = " ".join(f"'{word}'" for word in SHORT)
    files = ("share/man/man1/tdbd.1.gz", "share/doc/tdbd/copyright", "lib/cmake/tdbd/tdbdConfig.cmake", "include/tdbd/rock/rock.hpp")
    printed = run(*inside(root, "tdbd --version; python3 -c 'import tdbd; print(\"python\", tdbd.__version__)'; tdbd new drilling new; "
                                f"tdbd run new/*.toml -o result {short} --quiet; tdbd report result; "
                                + "; ".join(f"test -s /usr/{file}" for file in files)))
    check_version(printed, version)


def test_deb_unpacked(root, deb, version):
    """Without a fresh Debian: the package in a folder of its own, with the libraries of this machine."""
    run("dpkg-deb", "-x", deb, root)
    program, work = root / "usr/bin/tdbd", root / "work"
    work.mkdir()
    shutil.copytree(root / "usr/share/tdbd/cases", work / "cases")
    timed("unpacked: the first hole is drilled", program, *HOLE, cwd=work)
    timed("unpacked: the first hole is drawn", program, "draw", "first", cwd=work)
    printed = run(program, "--version")
    printed += run("/usr/bin/python3", "-c", "import tdbd; print('python', tdbd.__version__)",
                   env=os.environ | {"PYTHONPATH": str(root / "usr/lib/python3/dist-packages")})
    run(program, "new", "drilling", "new", cwd=work)
    run(program, "run", next((work / "new").glob("*.toml")), "-o", "result", *SHORT, "--quiet", cwd=work)
    check_version(printed, version)


def check_version(printed, version):
    for words in (f"tdbd {version}\n", f"python {version}\n"):
        if words not in printed:
            sys.exit(f"{NAME}: found the versions {printed!r}, expected {words!r}")


def test_wheel(work, wheel, source, version):
    """The wheel in a virtual environment of this machine, with the sources of the archive beside it."""
    run("tar", "-xf", source, "-C", work)
    sources = next(work.glob("tdbd-*"))
    python = work / "venv/bin/python"
    run("/usr/bin/python3", "-m", "venv", work / "venv")
    fetched = subprocess.run([python, "-m", "pip", "install", "-q", f"{wheel}[all]"], capture_output=True, text=True, check=False)
    if fetched.returncode != 0:
        say("no package index is reachable: numpy, matplotlib, xarray and netCDF4 are those of Debian (--system-site-packages)")
        run("/usr/bin/python3", "-m", "venv", "--clear", "--system-site-packages", work / "venv")
        run(python, "-m", "pip", "install", "-q", "--no-index", "--no-deps", wheel)
    alone = {"cwd": work, "env": {"PATH": str(work / "venv/bin"), "HOME": str(work)}}
    timed("a script runs with the wheel", python, "-c", SCRIPT, version, sources / "cases/bit-b-steady.toml", **alone)
    timed("the notebooks run with the wheel", python, "-B", "-c", NOTEBOOKS, sources / "python/notebooks", **alone)


def only(folder, pattern):
    found = sorted(folder.glob(pattern))
    if len(found) != 1:
        sys.exit(f"{NAME}: found {len(found)} files {folder}/{pattern}, expected 1 (bash scripts/package)")
    return found[0]


def main():
    folder, version = Path(sys.argv[1]).resolve(), sys.argv[2]
    deb, wheel, source = only(folder, f"tdbd_{version}_*.deb"), only(folder, f"tdbd-{version}-*.whl"), only(folder, f"tdbd-{version}.tar.gz")
    run("sha256sum", "--check", "--quiet", "SHA256SUMS", cwd=folder)
    if wheel.stat().st_size > SIZE_OF_WHEEL:
        sys.exit(f"{NAME}: the wheel has {wheel.stat().st_size / 1e6:.1f} MB, expected at most {SIZE_OF_WHEEL / 1e6:.0f} MB")
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        started = time.monotonic()
        reason = make_debian(work / "debian")
        if reason:
            say(f"no fresh Debian 12: {reason}; the package is unpacked into a folder and uses the libraries of this machine")
            (work / "root").mkdir()
            test_deb_unpacked(work / "root", deb, version)
        else:
            say(f"a fresh minimal Debian 12 was made by mmdebstrap: {time.monotonic() - started:.1f} s")
            run("cp", "-a", work / "debian", work / "second")
            test_deb_in_debian(work / "debian", deb, version)
            test_wheel_in_debian(work / "second", wheel, version)
        test_wheel(work, wheel, source, version)
    say("all packages passed")


if __name__ == "__main__":
    main()
