"""Reads the errors that the checks of tests recorded, and determines the kind of each check."""

import csv
import pathlib
import re
from dataclasses import dataclass, replace

MOST = 3.0  # the largest permitted ratio of tolerance to observed error
ROUNDING = 1e-12  # below it an observed error depends on the order in which a compiler adds
LITERAL = re.compile(r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+)(?:e[-+]?\d+)?(?![\w.])")
COMPARISON = re.compile(r"<=?(?![<=\w:]*>)")
PROMISE = "tolerance::"  # of src/core/tolerance.hpp: documented limits of the program, which a test does not choose
REASON = "wide:"  # begins a comment that explains why a tolerance is wider


@dataclass(frozen=True)
class Check:
    file: str
    line: int
    words: str  # the expression of the tolerance; for RC_ASSERT the whole expression
    times: int
    share: float  # the largest ratio of observed to allowed
    observed: float
    allowed: float
    scale: float = 0.0  # the larger of what is compared


def read(folder, root):
    """The checks of all processes that wrote to the folder, each with its largest share."""
    found = {}
    for file in sorted(pathlib.Path(folder).rglob("*.tsv")):
        with file.open(encoding="utf-8", newline="") as text:
            for path, line, times, share, observed, allowed, scale, words in csv.reader(text, delimiter="\t", quoting=csv.QUOTE_NONE):
                where = (str(pathlib.Path(path).relative_to(root)), int(line), words)
                check = Check(*where, int(times), *map(float, (share, observed, allowed, scale)))
                known = found.get(where)
                if known:
                    worse = max(known, check, key=lambda c: c.share)
                    check = replace(worse, times=known.times + check.times)
                found[where] = check
    return [found[where] for where in sorted(found)]


def allowed_words(words):
    """The right side of the first comparison, if there is one: `b` of `a < b && c`."""
    parts = COMPARISON.split(words, maxsplit=1)
    return re.split(r"&&|\|\|", parts[-1])[0].strip() if len(parts) == 2 else words


def constants(text):
    """{name: number} that a text declares: constexpr double rounding = 1e-12."""
    return {name: float(number) for declared in re.findall(r"constexpr double ([^;]*);", text)
            for name, number in re.findall(r"(\w+)\s*=\s*(" + LITERAL.pattern + r")\s*(?:,|$)", declared)}


def numbers(words, known):
    """The numbers in the expression of the tolerance, literal or by name."""
    allowed = allowed_words(words)
    return [float(n) for n in LITERAL.findall(allowed)] + [known[name] for name in re.findall(r"(?<![\w.])[A-Za-z_]\w*", allowed) if name in known]


def says_why(lines, line):
    """Whether a comment in the statement of the check or directly above it explains its wide tolerance."""
    end = line
    while end < len(lines) and end < line + 4 and not lines[end - 1].split("//")[0].rstrip().endswith(";"):
        end += 1
    first = line
    while first > 1 and lines[first - 2].strip().startswith("//"):
        first -= 1
    return any(REASON in text for text in lines[first - 1:end])


def kind(check, text):
    """The kind of a check (README.md): tight, bound, said, rounding or loose. text: the text of its file."""
    if check.share * MOST >= 1.0:
        return "tight"
    found = numbers(check.words, constants(text))
    if not found or PROMISE in allowed_words(check.words):
        return "bound"
    if says_why(text.split("\n"), check.line):
        return "said"
    return "rounding" if check.allowed <= ROUNDING * max(1.0, check.scale) or min(found) <= ROUNDING else "loose"
