#!/usr/bin/python3
"""Writes the table of measurements in docs/evidence/accuracy.md, or compares it with the data.

    reports/readme.py --write [--build DIR]     from evidence and studies; also writes reports/readme.json
    reports/readme.py --check                   the page and the studies against reports/readme.json

reports/readme.json stores the numbers, so that the page can be checked before any test has run. `scripts/report --readme` calls
the first command. Tests and `scripts/report --check` call the second; the latter also compares with the evidence.
"""

import argparse
import json
import os
import sys
from pathlib import Path

import evidence
import manifest as manifests
from fingerprint import Stale
from readme_rows import ROWS, Measured

HERE = Path(__file__).resolve().parent
BEGIN, END = "<!-- measured: scripts/report --readme writes what follows -->", "<!-- end of measured -->"
REMEDY = "run scripts/report --readme"
PAGE = "docs/evidence/accuracy.md"


def text_of(row, numbers):
    values = row.value.format(*(numbers[n.key()] for n in row.numbers))
    return f"| {row.what} | {values} | {row.by} |"


def block(numbers, rows):
    return [BEGIN, "| | measured | by |", "|---|---|---|", *(text_of(row, numbers) for row in rows), END]


def read_kept(root):
    """Raises Stale."""
    file = Path(root) / "reports/readme.json"
    if not file.is_file():
        raise Stale(f"reports/readme.json: has not been written; {REMEDY}")
    return json.loads(file.read_text(encoding="utf-8"))


def measure(root, found, rows=tuple(ROWS)):
    """All numbers, from evidence and studies. Raises Stale."""
    return {n.key(): n.read(found if isinstance(n, Measured) else root) for row in rows for n in row.numbers}


def place_of(lines):
    """The first line of the block in the page, and the line after it. Raises Stale."""
    if lines.count(BEGIN) != 1 or lines.count(END) != 1 or lines.index(END) < lines.index(BEGIN):
        raise Stale(f"{PAGE}: expected one line {BEGIN!r} and after it one {END!r}")
    return lines.index(BEGIN), lines.index(END) + 1


def write(root, numbers, rows=tuple(ROWS)):
    page = Path(root) / PAGE
    lines = page.read_text(encoding="utf-8").split("\n")
    first, end = place_of(lines)
    lines[first:end] = block(numbers, rows)
    (Path(root) / "reports/readme.json").write_text(json.dumps(numbers, indent=1) + "\n", encoding="utf-8")
    page.write_text("\n".join(lines), encoding="utf-8")


def edited_lines(root, numbers, rows=tuple(ROWS)):
    """Lines of the page that do not match the numbers, as a list of problems."""
    lines = (Path(root) / PAGE).read_text(encoding="utf-8").split("\n")
    try:
        first, end = place_of(lines)
    except Stale as stale:
        return [str(stale)]
    found, expected = lines[first:end], block(numbers, rows)
    if len(found) != len(expected):
        return [f"{PAGE}, line {first + 1}: found {len(found)} lines of measurements, expected {len(expected)}; {REMEDY}"]
    return [f"{PAGE}, line {first + i + 1}: found {a!r}, expected {b!r}; {REMEDY}"
            for i, (a, b) in enumerate(zip(found, expected)) if a != b]


def stale_numbers(root, numbers, found, rows=tuple(ROWS)):
    """Rows that differ from the current results of tests and studies, as a list of problems. `found`: evidence, or None."""
    problems = []
    for row in rows:
        try:
            now = {n.key(): numbers[n.key()] if isinstance(n, Measured) and found is None else
                   n.read(found if isinstance(n, Measured) else root) for n in row.numbers}
            if text_of(row, now) != text_of(row, numbers):
                problems.append(f"{PAGE}: measured now {text_of(row, now)!r}, reports/readme.json has {text_of(row, numbers)!r}; {REMEDY}")
        except KeyError as missing:
            problems.append(f"reports/readme.json has no number {missing}; {REMEDY}")
        except Stale as stale:
            problems.append(str(stale))
    return problems


def orphans(numbers, rows=tuple(ROWS)):
    """Stored numbers that no row uses, as a list of problems."""
    used = {n.key() for row in rows for n in row.numbers}
    return [f"reports/readme.json: unused number, no row of reports/readme_rows.py reads {key!r}; {REMEDY}" for key in numbers if key not in used]


def has_block(root):
    page = Path(root) / PAGE
    return (Path(root) / "reports/readme.json").is_file() or page.is_file() and BEGIN in page.read_text(encoding="utf-8")


def problems(root, found=None):
    """All problems of the block; with evidence also numbers that are stale. A project without a block has no problems."""
    if not has_block(root):
        return []
    try:
        numbers = read_kept(root)
    except Stale as stale:
        return [str(stale)]
    return orphans(numbers) + (stale_numbers(root, numbers, found) or edited_lines(root, numbers))


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    mode = parser.add_mutually_exclusive_group(required=True)
    mode.add_argument("--write", action="store_true")
    mode.add_argument("--check", action="store_true")
    parser.add_argument("--build", type=Path, default=HERE.parent / "build/release")
    chosen = parser.parse_args(arguments)
    root = HERE.parent
    try:
        if chosen.check:
            found = problems(root)
        else:
            folder = Path(os.environ.get("TDBD_EVIDENCE") or chosen.build / "evidence")
            collected = evidence.collect(folder, chosen.build, manifests.read(root / "reports", False).claims)
            write(root, measure(root, collected.by_claim))
            found = []
    except Stale as stale:
        found = [str(stale)]
    for problem in found:
        print(f"readme: {problem}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
