"""Every source of TDBD is compiled without contraction and without fast-math."""

import argparse
import json
import pathlib
import shlex

import sources

FORBIDDEN = ("-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-fassociative-math",
             "-freciprocal-math", "-ffinite-math-only", "-march=native")


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
    return [p for e in entries for p in check_command(e["file"], shlex.split(e["command"]))]


def self_test():
    good = "c++ -O3 -ffp-contract=off -fno-fast-math -c a.cpp"
    bad = ["c++ -O3 -c a.cpp", good + " -ffast-math", good + " -Ofast",
           good + " -ffp-contract=fast", good + " -march=native"]
    assert not check_command("a.cpp", good.split())
    for command in bad:
        assert check_command("a.cpp", command.split()), command


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--database", default=sources.ROOT / "build/release/compile_commands.json")
    parser.add_argument("--self-test", action="store_true")
    chosen = parser.parse_args()
    if chosen.self_test:
        sources.prove(self_test)
    else:
        sources.finish(check_database(chosen.database))
