"""All mutants of a source, and the draw of a sample. The order of the draw follows from hashes of the seed, the function and the text, so that
a change of one function does not change the order of the others, and a function may move to another file."""

import collections
import hashlib
from dataclasses import dataclass

import lines
import plain
import scopes
import subtle


@dataclass(frozen=True)
class Mutant:
    file: str  # relative to the repository
    line: int  # from 1
    function: str  # qualified
    place: int  # among the equal lines of its function, from 0
    operator: str
    before: str  # the line
    after: str

    @property
    def is_subtle(self):
        return self.operator in subtle.SUBTLE


def of_line(file, line, owner="", place=0):
    """The mutants of a line, by operator and column; no two have the same text."""
    found, seen = [], {line.text}
    for operator, function in {**subtle.SUBTLE, **plain.PLAIN}.items():
        if operator == "deleted statement" and not line.whole:
            continue
        for start, end, new in function(line.code):
            after = line.text[:start] + new + line.text[end:]
            if "~" not in new and after not in seen:
                seen.add(after)
                found.append(Mutant(file, line.number, owner, place, operator, line.text, after))
    return found


def of_source(file, text):
    functions, times, found = scopes.of_lines(text), collections.Counter(), []
    for line in lines.mutable(text):
        same = functions[line.number - 1], line.text.strip()
        found += of_line(file, line, same[0], times[same])
        times[same] += 1
    return found


def mutated(text, mutant):
    """The source with the mutant in it."""
    all_lines = text.split("\n")
    if all_lines[mutant.line - 1] != mutant.before:
        raise ValueError(f"{mutant.file}:{mutant.line}: found {all_lines[mutant.line - 1]!r}, expected {mutant.before!r}")
    all_lines[mutant.line - 1] = mutant.after
    return "\n".join(all_lines)


def rank(seed, *words):
    return hashlib.sha256("\0".join(map(str, (seed, *words))).encode()).hexdigest()


def in_rounds(mutants, seed):
    """One mutant of each line, the lines by their hash, each operator as likely as the others; then a second one, and so on."""
    def key(m):
        place = (seed, m.function, m.before.strip(), m.place)
        return rank(*place, m.operator), rank(*place, m.operator, m.after.strip())

    by_line = {}
    for m in sorted(mutants, key=key):
        by_line.setdefault((m.file, m.line), []).append(m)
    order = sorted(by_line.values(), key=lambda line: rank(seed, line[0].is_subtle, line[0].function, line[0].before.strip(), line[0].place))
    for i in range(max(map(len, order), default=0)):
        yield from (line[i] for line in order if i < len(line))


def drawn(mutants, seed):
    """The mutants in the order of the draw: subtle and plain ones in turn, as long as there are both."""
    halves = [in_rounds([m for m in mutants if m.is_subtle == is_subtle], seed) for is_subtle in (True, False)]
    while halves:
        for half in list(halves):
            mutant = next(half, None)
            if mutant is None:
                halves.remove(half)
            else:
                yield mutant
