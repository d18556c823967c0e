"""clang-tidy, as .clang-tidy says, over every source of src, by the folder as they are compiled; what passed unchanged is
not rerun.

tidy_passed.txt holds hashes of what passed, of a source with all its headers, its command line and .clang-tidy,
so that a fresh clone asks only about what changed since. `tidy.py --build BUILD --record` writes it anew from what
passes; without the file everything is asked again (some three minutes of two cores).
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
RECORD = pathlib.Path(__file__).with_name("tidy_passed.txt")
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
    """The complaints about one file, as one text. Compiler warnings are the build's business: -w."""
    run = subprocess.run([tool(), "--quiet", "--extra-arg=-w", f"--config-file={sources.ROOT / '.clang-tidy'}",
                          str(path), *extra], cwd=sources.ROOT, capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def project_files(path, seen):
    """The file and all headers of ours that it includes, directly or through others."""
    if path not in seen and path.is_file():
        seen.add(path)
        for header in INCLUDE.findall(path.read_text(encoding="utf-8")):
            project_files(sources.ROOT / "src" / header, seen)
    return seen


def verdict_key(path, command):
    """Hash of all that can change clang-tidy's verdict on the file, system headers apart."""
    portable = command.replace(str(sources.ROOT), ".")
    digest = hashlib.sha256(portable.encode() + (sources.ROOT / ".clang-tidy").read_bytes())
    for file in sorted(project_files(pathlib.Path(path), set())):
        content = file.read_bytes().replace(str(sources.ROOT).encode(), b".")
        digest.update(f"\0{file.relative_to(sources.ROOT)}\0".encode() + content)
    return digest.hexdigest()


def recorded():
    return set(RECORD.read_text(encoding="utf-8").split()) if RECORD.is_file() else set()


def check_file(path, command, build):
    key = verdict_key(path, command)
    passed = build / "tidy-passed" / key
    if passed.exists() or key in recorded():
        return ""
    complaints = run_tidy(path, ["-p", str(build / "tidy"), f"--header-filter={sources.ROOT}/src/.*"])
    if not complaints:
        passed.parent.mkdir(exist_ok=True)
        passed.touch()
    return complaints


def without_precompiled(command):
    """The command line without g++'s precompiled header, which clang cannot read, and what goes with it."""
    return PRECOMPILED.sub("", command)


def is_ours(source):
    """Whether it is a source of src, or the sources of one of its folders together, as they are compiled."""
    together = UNITY.search(source) is not None and f"{sources.ROOT}/src/" in pathlib.Path(source).read_text(encoding="utf-8")
    return together or source.startswith(f"{sources.ROOT}/src/")


def commands(build):
    """{source: command line} of src; the same for clang-tidy in build/tidy/compile_commands.json."""
    entries = [{**e, "command": without_precompiled(e["command"])}
               for e in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")) if is_ours(e["file"])]
    (build / "tidy").mkdir(exist_ok=True)
    (build / "tidy/compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")
    return {e["file"]: e["command"] for e in entries} or sys.exit("compile_commands.json lists no file of src")


def check_all(build):
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        found = pool.map(lambda item: check_file(*item, build), sorted(commands(build).items()))
    return [complaints for complaints in found if complaints]


def record(build):
    """Everything passes: note it."""
    keys = sorted(verdict_key(*item) for item in commands(build).items())
    RECORD.write_text("\n".join(keys) + "\n", encoding="utf-8")


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
    parser.add_argument("--record", action="store_true", help="write tidy_passed.txt if all pass")
    chosen = parser.parse_args()
    if chosen.self_test:
        sources.prove(self_test)
    else:
        complaints = check_all(chosen.build)
        if chosen.record and not complaints:
            record(chosen.build)
        sources.finish(complaints)
