#!/usr/bin/python3
"""Makes a wheel of the Python package from a finished build. It runs without a compiler and without other system libraries.

    packaging/wheel.py BUILD VERSION FOLDER      writes FOLDER/tdbd-VERSION-cp311-cp311-manylinux_2_36_x86_64.whl

- The wheel contains the shared libraries that the module links, except those of the C and C++ run time. Each has a name of
  its own, so that it can be loaded beside the library of the same name of another package.
- NetCDF and HDF5 link libraries for network access (NETWORK), which TDBD does not use: it reads local files. The wheel
  replaces them by libraries whose functions do nothing and return zero. Opening an address fails.
- The database of UDUNITS-2 and the licences of all libraries are included.

Times and order of the files are fixed: SOURCE_DATE_EPOCH (s) is the time of every file. Wheels of one build are bitwise
identical.
"""

import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# Every Linux with Python has these.
RUN_TIME = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+))\.so\.\d+")
NETWORK = ("libcurl-gnutls.so.4", "libcurl.so.4", "libxml2.so.2", "libcrypto.so.3")
UNITS = Path("/usr/share/xml/udunits")
METADATA = """Metadata-Version: 2.1
Name: tdbd
Version: {version}
Summary: Three Dimensional Bit Dynamics: drill bits cutting rock
License: GPL-3.0-or-later
Classifier: License :: OSI Approved :: GNU General Public License v3 or later (GPLv3+)
Classifier: Operating System :: POSIX :: Linux
Classifier: Programming Language :: Python :: 3
Requires-Python: =={python}.*
Requires-Dist: numpy
Provides-Extra: all
Requires-Dist: matplotlib; extra == 'all'
Requires-Dist: netCDF4; extra == 'all'
Requires-Dist: xarray; extra == 'all'
Description-Content-Type: text/markdown

"""


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True).stdout


def needed(file):
    return re.findall(r"(?m)^  NEEDED +(\S+)", run("objdump", "-p", file))


def linked(module):
    """{name: file} of the libraries that belong into the wheel. Those of NETWORK and their own libraries are not followed."""
    places = dict(re.findall(r"(?m)^\s*(\S+) => (/\S+)", run("ldd", module)))
    found, waiting = {}, [module]
    while waiting:
        for name in needed(waiting.pop()):
            if name not in found and name not in NETWORK and not RUN_TIME.fullmatch(name):
                if name not in places:
                    sys.exit(f"wheel: {module.name} links {name}, which is not installed")
                found[name] = Path(os.path.realpath(places[name]))
                waiting.append(found[name])
    return found


def wanted_symbols(files, library):
    """{version: {symbol: its kind}} that the files require from a library. Kinds: DF function, DO data."""
    symbols = {}
    for file in files:
        section = re.search(rf"required from {re.escape(library)}:\n((?:    .*\n)+)", run("objdump", "-p", file))
        for version in re.findall(r"(\S+)$", section.group(1), re.M) if section else ():
            rows = re.findall(rf"(?m) (DF|DO) \*UND\*\s+\S+ +\(?{re.escape(version)}\)? +(\S+)$", run("objdump", "-T", file))
            symbols.setdefault(version, {}).update({symbol: kind for kind, symbol in rows})
    return symbols


def make_empty_library(target, name, symbols):
    """A shared library whose functions do nothing and return zero."""
    with tempfile.TemporaryDirectory() as work:
        source, script = Path(work) / "empty.c", Path(work) / "empty.map"
        source.write_text("".join(f"long {symbol}(void) {{ return 0; }}\n" if kind == "DF" else f"void *{symbol};\n"
                                  for own in symbols.values() for symbol, kind in sorted(own.items())), encoding="utf-8")
        script.write_text("".join(f"{version} {{ {' '.join(f'{symbol};' for symbol in sorted(own))} }};\n"
                                  for version, own in sorted(symbols.items())), encoding="utf-8")
        run("gcc", "-shared", "-fPIC", "-Os", "-w", "-fno-builtin", f"-Wl,-soname,{name}", f"-Wl,--version-script,{script}", "-Wl,--build-id=none",
            "-o", target, source)


def own_name(name, contents):
    """The name of a library in the wheel: libgsl.so.27 becomes libgsl-5d02bd0b.so.27."""
    stem, ending = name.split(".so", 1)
    return f"{stem}-{hashlib.sha256(contents).hexdigest()[:8]}.so{ending}"


def collect_libraries(module, folder):
    """Copies the libraries of the module into the folder, under new names, and links module and libraries with them.
    Returns the Debian packages of the libraries."""
    folder.mkdir()
    libraries = linked(module)
    renamed = {name: own_name(name, file.read_bytes()) for name, file in libraries.items()}
    for name in NETWORK:
        symbols = wanted_symbols(libraries.values(), name)
        renamed[name] = own_name(name, repr(symbols).encode())
        make_empty_library(folder / renamed[name], renamed[name], symbols)
    words = [word for pair in renamed.items() for word in ("--replace-needed", *pair)]
    for name, file in libraries.items():
        copy = folder / renamed[name]
        shutil.copyfile(file, copy)
        for change in (["--set-soname", copy.name], words, ["--set-rpath", "$ORIGIN"]):  # patchelf 0.14 confuses them in one call
            run("patchelf", *change, copy)
    run("strip", "--strip-unneeded", module)
    run("patchelf", *words, module)
    run("patchelf", "--set-rpath", f"$ORIGIN/../{folder.name}", module)
    for file in [module, *folder.iterdir()]:
        if file != module and f"SONAME               {file.name}\n" not in run("objdump", "-p", file):
            sys.exit(f"wheel: patchelf did not rename {file.name}")
        for name in needed(file):
            if name not in renamed.values() and not RUN_TIME.fullmatch(name):
                sys.exit(f"wheel: {file.name} still links {name} of the system")
    return sorted({run("dpkg", "-S", f"*/{file.name}").split(":")[0] for file in libraries.values()})


def c_library_version(files):
    """The least version of the GNU C library that all files accept, such as (2, 36)."""
    versions = [(int(a), int(b)) for file in files for a, b in re.findall(r"GLIBC_(\d+)\.(\d+)", run("objdump", "-p", file))]
    return max(versions)


def write_wheel(stage, target, tags, date):
    """Packs the staged files with their RECORD."""
    info = next(stage.glob("*.dist-info"))
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: tdbd\nRoot-Is-Purelib: false\nTag: {tags}\n", encoding="utf-8")
    files = sorted(file for file in stage.rglob("*") if file.is_file())
    record = ""
    for file in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
        record += f"{file.relative_to(stage)},sha256={digest},{file.stat().st_size}\n"
    own = info / "RECORD"
    own.write_text(record + f"{own.relative_to(stage)},,\n", encoding="utf-8")
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for file in [*files, own]:
            entry = zipfile.ZipInfo(str(file.relative_to(stage)), time.gmtime(date)[:6])
            entry.external_attr = (0o100755 if ".so" in file.name else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(entry, file.read_bytes(), compresslevel=9)


def main():
    if len(sys.argv) != 4:
        sys.exit("wheel: found no BUILD VERSION FOLDER, expected the three")
    build, version, folder = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])
    package = build / "python/tdbd"
    modules = sorted(package.glob("_core.*.so"))
    if not modules:
        sys.exit(f"wheel: found no Python module in {package}, expected a build with pybind11-dev and python3-dev (target tdbd_python)")
    tag = "cp" + re.search(r"cpython-(\d+)-", modules[0].name).group(1)
    with tempfile.TemporaryDirectory() as work:
        stage = Path(work)
        (stage / "tdbd").mkdir()
        for file in package.iterdir():  # links to the sources
            if file.is_file():
                shutil.copyfile(file, stage / "tdbd" / file.name)
        shutil.copytree(UNITS, stage / "tdbd/udunits", symlinks=False)
        module = stage / "tdbd" / modules[0].name
        packages = collect_libraries(module, stage / "tdbd.libs")
        info = stage / f"tdbd-{version}.dist-info"
        (info / "licenses").mkdir(parents=True)
        text = METADATA.format(version=version, python=f"{tag[2]}.{tag[3:]}")
        (info / "METADATA").write_text(text + (ROOT / "python/README.md").read_text(encoding="utf-8"), encoding="utf-8")
        shutil.copyfile(ROOT / "LICENSE", info / "licenses/LICENSE")
        for name in packages:
            shutil.copyfile(f"/usr/share/doc/{name}/copyright", info / "licenses" / name)
        least = c_library_version([module, *(stage / "tdbd.libs").iterdir()])
        platform = f"manylinux_{least[0]}_{least[1]}_{os.uname().machine}"
        target = folder / f"tdbd-{version}-{tag}-{tag}-{platform}.whl"
        write_wheel(stage, target, f"{tag}-{tag}-{platform}", int(os.environ.get("SOURCE_DATE_EPOCH", "315619200")))
    print(f"wheel: {target}, {target.stat().st_size / 1e6:.1f} MB, with the libraries of {len(packages)} packages")


if __name__ == "__main__":
    main()
