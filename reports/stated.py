#!/usr/bin/python3
"""Numbers in the prose of READMEs: each comes from a file of the repository, or says what was chosen rather than measured.

    reports/stated.py --write     numbers of the prose anew, from the data
    reports/stated.py --check     exit code 1 if a number is not what the data say, or comes from nowhere

stated.py beside a README.md has a function stated(), which yields (PHRASE, NUMBER, ...): a piece of the text with a place for
each number, as str.format has them; and a list GIVEN of pieces of the text whose numbers were chosen: sizes, speeds, what was
asked. Every number of the prose stands in one of the two. Code, tables, dates, citations and links are not prose.
`scripts/report --readme` calls the first, tests and `scripts/report --check` the second.
"""

import argparse
import importlib.util
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
REMEDY = "run scripts/report --readme"
FIELD = re.compile(r"\{[^{}]*\}")
NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
WORD = re.compile(rf"(?<![\w.]){NUMBER}(?![\w])")
# What is not prose, in this order. Blanks take its place, so that a place in the text stays one.
NOT_PROSE = [re.compile(pattern, flags) for pattern, flags in (
    (r"<!--.*? begin -->.*?<!--.*? end -->", re.DOTALL),  # written by scripts
    (r"^```.*?^```", re.DOTALL | re.MULTILINE),
    (r"^(?: {4}|\|).*$", re.MULTILINE),  # code and tables
    (r"`[^`\n]*`", 0),
    (r"\]\([^)\n]*\)", 0),
    (r"\d*\^-?[\d.]+", 0),  # an exponent
    (r"\b\d{4}-\d{2}-\d{2}(?:(?:,| and| to) -?\d{2})*\b", 0),
    (r"\b(?:[Tt]hesis|figs?\.|[Ff]igures?|ch\.|app\.|eqs?\.|[Tt]ables?|[Cc]hapters?|[Ss]ections?) \d[\d.]*(?:(?:,| and| to) \d[\d.]*)*", 0),
    (r"\b[\w/]+ (?:\(\d+\)(?:,? (?:and |to )?)?)+", 0),  # rock (12)
)]


def prose(text):
    """The text with blanks for all that is no prose."""
    for pattern in NOT_PROSE:
        text = pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    return text


def spaced(piece):
    """A pattern for a piece of text, which may be wrapped anywhere."""
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
    """As the text has it: 2e-7, not 2e-07."""
    return re.sub(r"e([-+])0*(\d)", lambda e: "e" + e.group(1).replace("+", "") + e.group(2), field.format(number))


class Stated:
    """A README and what its stated.py says of it."""

    def __init__(self, root, module):
        self.root, self.readme = Path(root), module.parent / "README.md"
        spec = importlib.util.spec_from_file_location(f"stated_{abs(hash(str(module)))}", module)
        loaded = importlib.util.module_from_spec(spec)
        sys.path.insert(0, str(HERE))
        try:
            spec.loader.exec_module(loaded)
            self.phrases, self.given = [tuple(p) for p in loaded.stated()], list(loaded.GIVEN)
        finally:
            sys.path.remove(str(HERE))

    def name(self):
        return str(self.readme.relative_to(self.root))

    def text(self):
        return self.readme.read_text(encoding="utf-8")

    def places(self, text):
        """[(place in the text, found, expected, phrase)] of all stated numbers, and problems of phrases that are not there once."""
        numbers, problems = [], []
        for phrase, *values in self.phrases:
            fields, found = FIELD.findall(phrase), list(pattern_of(phrase).finditer(text))
            if len(fields) != len(values) or not fields:
                problems.append(f"{self.name()}: stated.py gives {len(values)} numbers for {phrase!r}, which has {len(fields)} places")
            elif len(found) != 1:
                problems.append(f"{self.name()}: found {len(found)} pieces of text like {phrase!r}, expected 1")
            else:
                numbers += [(found[0].span(i + 1), found[0].group(i + 1), written(f, v), phrase) for i, (f, v) in enumerate(zip(fields, values))]
        return numbers, problems

    def problems(self):
        text = self.text()
        numbers, problems = self.places(text)
        problems += [f"{self.name()}, line {line_of(text, span)}: found {found} in {phrase!r}, the data say {expected}; {REMEDY}"
                     for span, found, expected, phrase in numbers if found != expected]
        return problems + self.unsaid(text, [span for span, *_ in numbers])

    def unsaid(self, text, known):
        """Numbers of the prose that come from nowhere, and pieces of GIVEN that are gone."""
        problems = []
        for piece in self.given:
            found = [m.span() for m in re.finditer(spaced(piece), text)]
            known = known + found
            if not found:
                problems.append(f"{self.name()}: stated.py has {piece!r} among what is given, which the text has not")
        problems += [f"{self.name()}, line {line_of(text, m.span())}: {m.group()} comes from no file; state it or give it in stated.py beside it"
                     for m in WORD.finditer(prose(text)) if not any(a <= m.start() and m.end() <= b for a, b in known)]
        return problems

    def write(self):
        """Puts the numbers of the data into the text. Returns what cannot be done so."""
        text = self.text()
        numbers, problems = self.places(text)
        for (first, end), _, expected, _ in sorted(numbers, reverse=True):
            text = text[:first] + expected + text[end:]
        self.readme.write_text(text, encoding="utf-8")
        return problems


def line_of(text, span):
    return text.count("\n", 0, span[0]) + 1


def must_state(root):
    """READMEs whose every number must come from somewhere."""
    root = Path(root)
    return [f for f in (*sorted((root / "reports/studies").glob("*/README.md")), root / "benchmarks/README.md") if f.is_file()]


def find(root):
    """(what each stated.py says, problems of READMEs that lack one)."""
    root, found, problems = Path(root), [], []
    for readme in must_state(root):
        module = readme.with_name("stated.py")
        if module.is_file():
            found.append(Stated(root, module))
        elif numbers := WORD.findall(prose(readme.read_text(encoding="utf-8"))):
            problems.append(f"{readme.relative_to(root)}: {len(numbers)} numbers and no stated.py beside it, which says where they come from")
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
