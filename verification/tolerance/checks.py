"""What the checks of tests observed, and what kind of check each is."""

import csv
import pathlib
import re
from dataclasses import dataclass, replace

MOST = 3.0  # a tolerance may be so many times what is observed
ROUNDING = 1e-12  # below it an observation hangs on the order in which a compiler adds
LITERAL = re.compile(r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+)(?:e[-+]?\d+)?(?![\w.])")
COMPARISON = re.compile(r"<=?(?![<=\w:]*>)")
PROMISE = "tolerance::"  # of src/core/tolerance.hpp: what the program promises, which is not a test's to choose
REASON = "wide:"  # a comment at the check that begins so says why its tolerance is wider


@dataclass(frozen=True)
class Check:
    file: str
    line: int
    words: str  # what is allowed; for RC_ASSERT all of its words
    times: int
    share: float  # the largest of observed over allowed
    observed: float
    allowed: float
    scale: float = 0.0  # the larger of what is compared


def read(folder, root):
    """The checks of all processes that wrote into the folder, each with its largest share."""
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
    """Behind the first comparison, if there is one: `a < b && c` allows b."""
    parts = COMPARISON.split(words, maxsplit=1)
    return re.split(r"&&|\|\|", parts[-1])[0].strip() if len(parts) == 2 else words


def constants(text):
    """{name: number} that a text declares: constexpr double rounding = 1e-12."""
    return {name: float(number) for declared in re.findall(r"constexpr double ([^;]*);", text)
            for name, number in re.findall(r"(\w+)\s*=\s*(" + LITERAL.pattern + r")\s*(?:,|$)", declared)}


def numbers(words, known):
    """The numbers in what is allowed, written or by name."""
    allowed = allowed_words(words)
    return [float(n) for n in LITERAL.findall(allowed)] + [known[name] for name in re.findall(r"(?<![\w.])[A-Za-z_]\w*", allowed) if name in known]


def says_why(lines, line):
    """Whether a comment at the check, in its statement or just above it, says why its tolerance is wide."""
    end = line
    while end < len(lines) and end < line + 4 and not lines[end - 1].split("//")[0].rstrip().endswith(";"):
        end += 1
    first = line
    while first > 1 and lines[first - 2].strip().startswith("//"):
        first -= 1
    return any(REASON in text for text in lines[first - 1:end])


def kind(check, text):
    """tight, rounding, bound, said or loose. text: of its file."""
    if check.share * MOST >= 1.0:
        return "tight"
    found = numbers(check.words, constants(text))
    if not found or PROMISE in allowed_words(check.words):
        return "bound"
    if says_why(text.split("\n"), check.line):
        return "said"
    return "rounding" if check.allowed <= ROUNDING * max(1.0, check.scale) or min(found) <= ROUNDING else "loose"
