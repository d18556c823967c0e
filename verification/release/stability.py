#!/usr/bin/python3
"""Compares a stable surface of TDBD with its committed listing (docs/reference/stability.md).

    stability.py --bin build/release SURFACE                      compares; commands, settings, results, headers or python
    stability.py --bin build/release --write [SURFACE ...]        adds what is new to the listings: for a minor version
    stability.py --bin build/release --write --breaking SURFACE   replaces the listing: for a major version
    stability.py --self-test                                      shows that changes are found

A listing has one line for each name, with its detail after " : ".
"""

import argparse
import sys
from pathlib import Path

import surfaces

FOLDER = Path(__file__).resolve().parent / "listings"
TITLES = {"commands": "command line", "settings": "keys of input files", "results": "result fields", "headers": "public C++ headers",
          "python": "Python package"}
HEAD = "# Stable within a major version. Written by verification/release/stability.py --write; do not edit.\n"


def present(surface, build):
    """The surface as the build has it."""
    source = build / "python" if surface == "python" else (build / "tdbd").resolve()
    return getattr(surfaces, surface)(source)


def read(text):
    rows = {}
    for line in text.split("\n"):
        if line and not line.startswith("#"):
            name, _, detail = line.partition(" : ")
            rows[name] = detail
    return rows


def written(rows):
    return HEAD + "".join(f"{name} : {detail}\n" if detail else f"{name}\n" for name, detail in sorted(rows.items()))


def differences(listed, found):
    """(breaking, added): sentences about changes that need a major version, and about additions."""
    breaking = [f'"{name}" was removed' for name in sorted(listed.keys() - found.keys())]
    breaking += [f'"{name}" changed from "{listed[name]}" to "{found[name]}"' for name in sorted(listed.keys() & found.keys())
                 if listed[name] != found[name]]
    return breaking, [f'"{name}" is new' for name in sorted(found.keys() - listed.keys())]


def report(surface, breaking, added):
    """Prints what differs; returns the exit code."""
    for sentence in breaking:
        print(f"{TITLES[surface]}: {sentence}: this breaks what users have, and needs a new major version (docs/reference/stability.md)")
    for sentence in added:
        print(f"{TITLES[surface]}: {sentence}: add it to the listing with verification/release/stability.py --write {surface}; "
              "it is part of the next minor version")
    return 1 if breaking or added else 0


def write(surface, found, may_break):
    path = FOLDER / f"{surface}.txt"
    listed = read(path.read_text(encoding="utf-8")) if path.is_file() else {}
    breaking, added = differences(listed, found)
    if breaking and not may_break:
        report(surface, breaking, [])
        print(f"{path.name}: not written; --breaking writes it")
        return 1
    FOLDER.mkdir(exist_ok=True)
    path.write_text(written(found), encoding="utf-8")
    print(f"{path.name}: {len(found)} names, {len(added)} new, {len(breaking)} removed or changed")
    return 0


def self_test():
    """Every surface: a name that was removed, one that changed, and one that is new."""
    for surface in TITLES:
        text = (FOLDER / f"{surface}.txt").read_text(encoding="utf-8")
        listed = read(text)
        assert len(listed) > 50 and written(listed) == text, surface
        assert report(surface, *differences(listed, listed)) == 0
        name = sorted(listed)[7]
        assert differences(listed, {n: d for n, d in listed.items() if n != name}) == ([f'"{name}" was removed'], [])
        breaking, added = differences(listed, listed | {name: "other"})
        assert len(breaking) == 1 and "changed from" in breaking[0] and not added
        assert differences(listed, listed | {"other": ""}) == ([], ['"other" is new'])
        assert report(surface, breaking, []) == 1 and report(surface, [], ["new"]) == 1
    text = ("Options:\n  -o,--output FOLDER Excludes: --resume\n                              the folder\n  --quiet      nothing\n\n"
            "Example: a\n  --no option\n")
    assert surfaces.help_rows(text) == {"--output": "-o,--output FOLDER", "--quiet": ""}, surfaces.help_rows(text)
    found = surfaces.fields({"a": [{"b": 1}, {"c": None}], "d": {"cutter-1/face": "x"}, "counters": 1})
    assert found == {"a[].b": "number", "a[].c": "null", "d.*": "text"}, found
    print("changes of all surfaces are found")
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=Path, default=Path("build/release"), help="the build")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--breaking", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("surfaces", nargs="*", choices=[*TITLES, []], metavar="SURFACE")
    a = parser.parse_args()
    if a.self_test:
        return self_test()
    code = 0
    for surface in a.surfaces or TITLES:
        found = present(surface, a.bin)
        if a.write:
            code |= write(surface, found, a.breaking)
        else:
            listed = read((FOLDER / f"{surface}.txt").read_text(encoding="utf-8"))
            code |= report(surface, *differences(listed, found))
            print(f"{TITLES[surface]}: {len(found)} names")
    return code


if __name__ == "__main__":
    sys.exit(main())
