"""Every source is formatted according to .clang-format."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import sources


def check_files(paths):
    tool = shutil.which("clang-format")
    if tool is None:
        sys.exit("clang-format is missing (scripts/setup installs it)")
    style = f"file:{sources.ROOT / '.clang-format'}"
    run = subprocess.run([tool, "--dry-run", "-Werror", f"--style={style}", *paths],
                         cwd=sources.ROOT, capture_output=True, text=True)
    if run.returncode == 0:
        return []
    return [line for line in run.stderr.split("\n") if "error:" in line] or [run.stderr]


def check_all():
    return check_files(sources.tracked("src", "reference", "verification", "benchmarks", "examples", "python"))


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "a.cpp"
        source.write_text("int f(int a) { return a; }\n")
        assert not check_files([str(source)])
        source.write_text("int f( int a ){return a;}\n")
        assert check_files([str(source)])


if __name__ == "__main__":
    sources.main(check_all, self_test)
