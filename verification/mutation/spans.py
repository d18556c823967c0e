"""Pieces of a line of code: where the operand of an operator ends, which arguments a call has."""

import re

OPEN, CLOSE = "([{", ")]}"
# What ends a term at the depth where it began; a factor also ends at * and /.
TERM_END = re.compile(r" [-+] | [<>]=? | [!=]= | && | \|\| | \? | : | [-+*/]?= |[,;]")
FACTOR_END = re.compile(r" [-+*/%] | [<>]=? | [!=]= | && | \|\| | \? | : | [-+*/]?= |[,;]")


def end_of_operand(code, start, ends):
    """The column where the operand that begins at start ends; None if it continues in the next line."""
    depth = 0
    for i in range(start, len(code)):
        if depth == 0 and ends.match(code, i):
            return i
        if code[i] in OPEN:
            depth += 1
        elif code[i] in CLOSE:
            if depth == 0:
                return i
            depth -= 1
    return None


def matching(code, opening):
    """The column of the bracket that closes the one at `opening`; None when it is in another line."""
    depth = 0
    for i in range(opening, len(code)):
        depth += (code[i] in OPEN) - (code[i] in CLOSE)
        if depth == 0:
            return i
    return None


def arguments(code, opening):
    """[(start, end)] of the arguments of the call whose parenthesis opens there; [] when it does not close."""
    closing = matching(code, opening)
    if closing is None:
        return []
    spans, depth, start = [], 0, opening + 1
    for i in range(opening + 1, closing):
        depth += (code[i] in OPEN) - (code[i] in CLOSE)
        if depth == 0 and code[i] == ",":
            spans.append((start, i))
            start = i + 1
    spans.append((start, closing))
    return [(a + len(code[a:b]) - len(code[a:b].lstrip()), b) for a, b in spans]
