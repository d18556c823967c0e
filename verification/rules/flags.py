"""Every source of TDBD is compiled without contraction and without fast-math, and with -frounding-math if it includes CGAL."""

import argparse
import json
import pathlib
import re
import shlex

import sources

FORBIDDEN = ("-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-fassociative-math",
             "-freciprocal-math", "-ffinite-math-only", "-march=native")


CGAL = re.compile(r"^#include <CGAL/", re.MULTILINE)
UNITY = re.compile(r'^#include "(.*\.cpp)"$', re.MULTILINE)


def check_rounding(name, arguments, text):
    """The intervals of CGAL are wrong if the compiler assumes that the rounding mode does not change."""
    if not CGAL.search(text) or "-frounding-math" in arguments:
        return []
    return [f"{name}: includes CGAL, but is compiled without -frounding-math; link tdbd_cgal"]


def texts_of(file):
    """(name, text) of a source, or of all sources that are compiled together in it."""
    text = pathlib.Path(file).read_text(encoding="utf-8")
    parts = UNITY.findall(text) if "/Unity/" in file else []
    return [(part, pathlib.Path(part).read_text(encoding="utf-8")) for part in parts] or [(file, text)]


def check_command(name, arguments):
    problems = [f"{name}: compiled with {a}" for a in arguments if a in FORBIDDEN]
    contract = [a for a in arguments if a.startswith("-ffp-contract=")]
    if not contract or contract[-1] != "-ffp-contract=off":
        problems.append(f"{name}: compiled without -ffp-contract=off")
    return problems


def check_database(database):
    entries = json.loads(pathlib.Path(database).read_text(encoding="utf-8"))
    if not entries:
        return [f"{database}: lists no file"]
    problems = []
    for entry in entries:
        arguments = shlex.split(entry["command"])
        problems += check_command(entry["file"], arguments)
        for name, text in texts_of(entry["file"]):
            problems += check_rounding(name, arguments, text)
    return problems


def self_test():
    good = "c++ -O3 -ffp-contract=off -fno-fast-math -c a.cpp"
    bad = ["c++ -O3 -c a.cpp", good + " -ffast-math", good + " -Ofast",
           good + " -ffp-contract=fast", good + " -march=native"]
    assert not check_command("a.cpp", good.split())
    for command in bad:
        assert check_command("a.cpp", command.split()), command
    kernel = "#include <string>\n#include <CGAL/Simple_cartesian.h>\n"
    assert check_rounding("a.cpp", good.split(), kernel)
    assert not check_rounding("a.cpp", [*good.split(), "-frounding-math"], kernel)
    assert not check_rounding("a.cpp", good.split(), '#include "mesh/check/self_intersections.hpp"\n')


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--database", default=sources.ROOT / "build/release/compile_commands.json")
    parser.add_argument("--self-test", action="store_true")
    chosen = parser.parse_args()
    if chosen.self_test:
        sources.prove(self_test)
    else:
        sources.finish(check_database(chosen.database))
