"""clang-tidy with the checks of .clang-tidy passes on every source of src, by folder as they are compiled.

A unit that passed is not checked again until it changes: the folder tidy-passed of the build has a file for each, named by the hash of the
unit with its headers, its command line and .clang-tidy. Without that folder, as in a fresh clone, the rule is skipped (exit code 77): checking
all units takes several minutes. `bash scripts/tidy` (tidy.py --all) checks them and creates the folder.
"""

import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import sources

JOBS = 2
SKIPPED = 77  # the exit code that ctest takes for a skipped test
PRECOMPILED = re.compile(r" -(Winvalid-pch|fpch-preprocess|Wno-array-bounds|Wno-stringop-overflow|Wno-stringop-overread|Wno-restrict"
                         r"|fPIC|fvisibility=hidden|fvisibility-inlines-hidden|include \S*cmake_pch\.hxx)(?= )")
UNITY = re.compile(r"/Unity/unity_\w+\.cxx$")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def tool():
    found = shutil.which("clang-tidy")
    if found is None:
        sys.exit("clang-tidy is missing (scripts/setup installs it)")
    return found


def run_tidy(path, extra):
    """The messages about one file. Compiler warnings are left to the build: -w."""
    run = subprocess.run([tool(), "--quiet", "--extra-arg=-w", f"--config-file={sources.ROOT / '.clang-tidy'}",
                          str(path), *extra], cwd=sources.ROOT, capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def project_files(path, seen):
    """The file and all headers of TDBD that it includes, directly or indirectly."""
    if path not in seen and path.is_file():
        seen.add(path)
        for header in INCLUDE.findall(path.read_text(encoding="utf-8")):
            project_files(sources.ROOT / "src" / header, seen)
    return seen


def verdict_key(path, command):
    """Hash of everything that clang-tidy's result depends on, except system headers."""
    portable = command.replace(str(sources.ROOT), ".")
    digest = hashlib.sha256(portable.encode() + (sources.ROOT / ".clang-tidy").read_bytes())
    for file in sorted(project_files(pathlib.Path(path), set())):
        content = file.read_bytes().replace(str(sources.ROOT).encode(), b".")
        digest.update(f"\0{file.relative_to(sources.ROOT)}\0".encode() + content)
    return digest.hexdigest()


def cache(build):
    """The folder with a file for each unit that passed."""
    return build / "tidy-passed"


def check_file(path, command, build):
    passed = cache(build) / verdict_key(path, command)
    if passed.exists():
        return ""
    complaints = run_tidy(path, ["-p", str(build / "tidy"), f"--header-filter={sources.ROOT}/src/.*"])
    if not complaints:
        passed.touch()
    return complaints


def without_precompiled(command):
    """The command line without g++'s precompiled header, which clang cannot read, and without the related options."""
    return PRECOMPILED.sub("", command)


def is_ours(source):
    """Whether this is a source of src, or a unity source of one of its folders."""
    together = UNITY.search(source) is not None and f"{sources.ROOT}/src/" in pathlib.Path(source).read_text(encoding="utf-8")
    return together or source.startswith(f"{sources.ROOT}/src/")


def commands(build):
    """{source: command line} of src, which is also written to tidy/compile_commands.json of the build for clang-tidy."""
    entries = [{**e, "command": without_precompiled(e["command"])}
               for e in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")) if is_ours(e["file"])]
    (build / "tidy").mkdir(exist_ok=True)
    (build / "tidy/compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")
    return {e["file"]: e["command"] for e in entries} or sys.exit("compile_commands.json lists no file of src")


def check_all(build):
    cache(build).mkdir(exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        found = pool.map(lambda item: check_file(*item, build), sorted(commands(build).items()))
    return [complaints for complaints in found if complaints]


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "a.cpp"
        source.write_text("int twice(int value_in) { return 2 * value_in; }\n")
        assert not run_tidy(source, ["--", "-std=c++20"])
        for text in ("int TwiceIt(int v) { return 2 * v; }\n", "struct lower_case {};\n",
                     "#include <utility>\n#include <string>\nstd::size_t f(std::string s) {\n"
                     "  std::string t = std::move(s);\n  return s.size() + t.size();\n}\n"):
            source.write_text(text)
            assert run_tidy(source, ["--", "-std=c++20"]), text


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, default=sources.ROOT / "build/release")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--all", action="store_true", help="check all units that have not passed, even if none has")
    chosen = parser.parse_args()
    if chosen.self_test:
        sources.prove(self_test)
    elif not chosen.all and not cache(chosen.build).is_dir():
        print("skipped: no unit has been checked in this build yet; bash scripts/tidy checks all of them")
        sys.exit(SKIPPED)
    else:
        sources.finish(check_all(chosen.build))
