"""Installs TDBD into a temporary folder, builds the examples outside the tree against it and runs them."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

# One revolution that takes seconds.
CASE = "cases/bit-b-steady.toml"
COARSE = ["rock.edge_length=4 mm", "rock.wall=20 mm", "time.step=5 ms"]


def run(*command):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def check_no_build_paths(prefix, folders):
    """Text files of the package must not name the folders that it was built in."""
    for file in prefix.rglob("*"):
        if file.suffix not in (".cmake", ".hpp"):
            continue
        text = file.read_text(encoding="utf-8")
        for folder in folders:
            if str(folder) in text:
                sys.exit(f"{file.relative_to(prefix)} names {folder}")


def check_pages(prefix):
    """The manual page and bash's completion are those of the installed program."""
    for file, word in (("man/man1/tdbd.1", "--man"), ("bash-completion/completions/tdbd", "--completion")):
        if (prefix / "share" / file).read_text(encoding="utf-8") != run(prefix / "bin/tdbd", "help", word):
            sys.exit(f"{file} is not what the program prints")


def check_headers(a, prefix, work):
    """The public headers are installed and compile in one file, with the flags of an example."""
    lines = (a.source / "src/public_headers.txt").read_text(encoding="utf-8").split("\n")
    headers = [line for line in lines if line and not line.startswith("#")]
    missing = [header for header in headers if not (prefix / "include/tdbd" / header).is_file()]
    if missing:
        sys.exit(f"public headers that were not installed: {', '.join(missing)}")
    unit = work / "headers.cpp"
    unit.write_text("".join(f'#include "{header}"\n' for header in headers), encoding="utf-8")
    commands = json.loads((work / "ask_force_law/compile_commands.json").read_text(encoding="utf-8"))
    words = commands[0]["command"].split()
    folders = [word for before, word in zip(words, words[1:]) if before == "-isystem"]
    flags = [word for word in words if word.startswith(("-I", "-D", "-std"))]
    run(a.compiler, *flags, *(f"-isystem{folder}" for folder in folders), "-fsyntax-only", unit)


def build(a, prefix, work, name):
    folder = work / name
    run(a.cmake, "-S", a.source / "examples" / name, "-B", folder, "-G", "Ninja",
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={a.compiler}", f"-DCMAKE_CXX_FLAGS={a.flags}",
        f"-DCMAKE_BUILD_TYPE={a.build_type}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    command = json.loads((folder / "compile_commands.json").read_text(encoding="utf-8"))[0]["command"].split()
    for flag in ("-ffp-contract=off", "-DEIGEN_MAX_ALIGN_BYTES=0", "-DEIGEN_DONT_PARALLELIZE"):
        if flag not in command:
            sys.exit(f"{name} is compiled without {flag}")
    for flag in ("-Werror", "-frounding-math", f"-I{a.source / 'src'}"):
        if flag in command:
            sys.exit(f"{name} is compiled with {flag}")
    run(a.cmake, "--build", folder)
    return folder / name


def check_drilling(a, prefix, work):
    program = build(a, prefix, work, "drill_one_revolution")
    printed = dict(line.split() for line in run(program, a.source / CASE, *COARSE).splitlines())
    settings = [word for setting in COARSE + ["time.revolutions=1"] for word in ("--set", setting)]
    run(prefix / "bin/tdbd", "run", a.source / CASE, *settings, "-o", work / "result", "--quiet")
    summary = json.loads((work / "result/summary.json").read_text(encoding="utf-8"))
    for key in ("steps", "revolutions", "removed_volume_m3"):
        if float(printed[key]) != summary[key]:
            sys.exit(f"{key}: the example prints {printed[key]}, tdbd run writes {summary[key]}")
    if not summary["removed_volume_m3"] > 0:
        sys.exit("nothing was drilled")


def main():
    parser = argparse.ArgumentParser()
    for name in ("--cmake", "--compiler", "--build-type"):
        parser.add_argument(name, required=True)
    parser.add_argument("--flags", default="")
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    a = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        # Installed at one place and used at another: the package can be moved.
        run(a.cmake, "--install", a.build, "--prefix", work / "installed")
        prefix = work / "prefix"
        os.rename(work / "installed", prefix)
        check_no_build_paths(prefix, [a.source, a.build, work])
        check_pages(prefix)
        check_drilling(a, prefix, work)
        print(run(build(a, prefix, work, "rotate_body_with_cones")))
        print(run(build(a, prefix, work, "ask_force_law")))
        check_headers(a, prefix, work)


if __name__ == "__main__":
    main()
