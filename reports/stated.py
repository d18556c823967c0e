#!/usr/bin/python3
"""Checks or writes the numbers in the prose of READMEs. Each is computed from a file of the repository, or was chosen rather than measured.

    reports/stated.py --write     writes the numbers into the prose, computed from the data
    reports/stated.py --check     exit code 1 if a number differs from the data, or has no source

`[stated]` of the study.toml beside a README.md has two lists. Each entry of `numbers` is a piece of the text with a
placeholder of str.format for each number, and an expression for each number, or one expression for a list of all. `given` has
pieces of the text whose numbers were chosen: sizes, speeds, goals. stated() of study.py yields further entries of `numbers`,
with values instead of expressions. Every number of the prose is in one of the two lists. Code, tables, dates, citations and
links are not prose. `scripts/report --readme` calls the first command; tests and `scripts/report --check` call the second.
"""

import argparse
import re
import sys
from pathlib import Path

import study as studies_of
from fingerprint import Stale

HERE = Path(__file__).resolve().parent
REMEDY = "run scripts/report --readme"
FIELD = re.compile(r"\{[^{}]*\}")
NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
WORD = re.compile(rf"(?<![\w.]){NUMBER}(?![\w])")
# Text that is not prose, in the order of removal. It is replaced by blanks, so that positions in the text do not change.
NOT_PROSE = [re.compile(pattern, flags) for pattern, flags in (
    (r"<!--.*? begin -->.*?<!--.*? end -->", re.DOTALL),  # written by scripts
    (r"^```.*?^```", re.DOTALL | re.MULTILINE),
    (r"^(?: {4}|\|).*$", re.MULTILINE),  # code and tables
    (r"`[^`\n]*`", 0),
    (r"\]\([^)\n]*\)", 0),
    (r"\d*\^-?[\d.]+", 0),  # an exponent
    (r"\b\d{4}-\d{2}-\d{2}(?:(?:,|\sand|\sto)\s-?\d{2})*\b", 0),
    (r"\b(?:[Tt]hesis|figs?\.|[Ff]igures?|ch\.|app\.|eqs?\.|[Tt]ables?|[Cc]hapters?|[Ss]ections?)\s\d[\d.]*(?:(?:,|\sand|\sto)\s\d[\d.]*)*", 0),
    (r"\b[\w/]+\s(?:\(\d+\)(?:,?\s(?:and\s|to\s)?)?)+", 0),  # rock (12)
)]


def prose(text):
    """The text, with everything that is not prose replaced by blanks."""
    for pattern in NOT_PROSE:
        text = pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    return text


def spaced(piece):
    """A pattern for a piece of text with line breaks at any space."""
    return r"\s+".join(re.escape(word) for word in piece.split())


def pattern_of(phrase):
    """The phrase as a pattern, with a group for each number."""
    parts = FIELD.split(phrase)
    edge = {True: r"\s+", False: ""}
    joined = ""
    for i, part in enumerate(parts):
        if i > 0:
            joined += f"({NUMBER})"
        inner = spaced(part)
        if inner:
            joined += edge[i > 0 and part[0].isspace()] + inner + edge[i + 1 < len(parts) and part[-1].isspace()]
        elif part:
            joined += r"\s+"
    return re.compile(joined)


def written(field, number):
    """The number as the text writes it: 2e-7, not 2e-07."""
    return re.sub(r"e([-+])0*(\d)", lambda e: "e" + e.group(1).replace("+", "") + e.group(2), field.format(number))


def values_of(study, expressions):
    """The numbers of expressions. An expression may return several, as a list or a tuple."""
    found = [study.value(e) for e in expressions]
    return [n for value in found for n in (value if isinstance(value, (list, tuple)) else [value])]


class Stated:
    """A README, and the numbers that the study.toml and the study.py in its folder give. Raises Stale if these fail."""

    def __init__(self, root, readme):
        self.root, self.readme = Path(root), readme
        study = studies_of.load(readme.parent)
        plan = study.plan.get("stated", {})
        self.given = list(plan.get("given", []))
        self.phrases = [(phrase, *values_of(study, expressions)) for phrase, *expressions in plan.get("numbers", [])]
        self.is_stated = bool(self.given or self.phrases)
        if own := study.function("stated"):
            self.phrases += [tuple(p) for p in own()]
            self.is_stated = True

    def name(self):
        return str(self.readme.relative_to(self.root))

    def text(self):
        return self.readme.read_text(encoding="utf-8")

    def places(self, text):
        """[(position in the text, found, expected, phrase)] of all stated numbers, and problems of phrases that do not occur exactly once."""
        numbers, problems = [], []
        for phrase, *values in self.phrases:
            fields, found = FIELD.findall(phrase), list(pattern_of(phrase).finditer(text))
            if len(fields) != len(values) or not fields:
                problems.append(f"{self.name()}: study.toml gives {len(values)} numbers for {phrase!r}, which has {len(fields)} placeholders")
            elif len(found) != 1:
                problems.append(f"{self.name()}: found {len(found)} pieces of text like {phrase!r}, expected 1")
            else:
                numbers += [(found[0].span(i + 1), found[0].group(i + 1), written(f, v), phrase) for i, (f, v) in enumerate(zip(fields, values))]
        return numbers, problems

    def problems(self):
        text = self.text()
        numbers, problems = self.places(text)
        problems += [f"{self.name()}, line {line_of(text, span)}: found {found} in {phrase!r}, the data give {expected}; {REMEDY}"
                     for span, found, expected, phrase in numbers if found != expected]
        return problems + self.without_source(text, [span for span, *_ in numbers])

    def without_source(self, text, known):
        """Numbers of the prose without a source, and pieces of `given` that the text does not contain."""
        problems = []
        for piece in self.given:
            found = [m.span() for m in re.finditer(spaced(piece), text)]
            known = known + found
            if not found:
                problems.append(f"{self.name()}: found no {piece!r} in the text, which `given` in study.toml contains")
        problems += [f"{self.name()}, line {line_of(text, m.span())}: {m.group()} has no source; add it to [stated] of the study.toml in its folder"
                     for m in WORD.finditer(prose(text)) if not any(a <= m.start() and m.end() <= b for a, b in known)]
        return problems

    def write(self):
        """Writes the numbers into the text. Returns the problems that remain."""
        text = self.text()
        numbers, problems = self.places(text)
        for (first, end), _, expected, _ in sorted(numbers, reverse=True):
            text = text[:first] + expected + text[end:]
        self.readme.write_text(text, encoding="utf-8")
        return problems


def line_of(text, span):
    return text.count("\n", 0, span[0]) + 1


def must_state(root):
    """The READMEs in which every number must have a source."""
    root = Path(root)
    return [f for f in (*sorted((root / "reports/studies").glob("*/README.md")), root / "benchmarks/README.md") if f.is_file()]


def find(root):
    """(READMEs with stated numbers, problems of READMEs without them)."""
    root, found, problems = Path(root), [], []
    for readme in must_state(root):
        try:
            one = Stated(root, readme)
        except Stale as error:
            problems.append(str(error))
            continue
        if one.is_stated:
            found.append(one)
        elif numbers := WORD.findall(prose(one.text())):
            problems.append(f"{one.name()}: found {len(numbers)} numbers and no [stated] in a study.toml in its folder, which gives their sources")
    return found, problems


def problems(root):
    found, missing = find(root)
    return missing + [p for s in found for p in s.problems()]


def write(root):
    found, missing = find(root)
    return missing + [p for s in found for p in s.write()]


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    mode = parser.add_mutually_exclusive_group(required=True)
    mode.add_argument("--write", action="store_true")
    mode.add_argument("--check", action="store_true")
    chosen = parser.parse_args(arguments)
    found = write(HERE.parent) if chosen.write else problems(HERE.parent)
    for problem in found:
        print(f"stated: {problem}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
