"""The subtle operators: faults that a reader misses. Each takes the code of a line and yields (from, to, new text)."""

import re

import spans

RELATIONS = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == "}
EXTREMES = {"std::min(": "std::max(", "std::max(": "std::min(", "cwiseMin(": "cwiseMax(", "cwiseMax(": "cwiseMin(",
            "minCoeff(": "maxCoeff(", "maxCoeff(": "minCoeff(", "std::min_element(": "std::max_element(",
            "std::max_element(": "std::min_element("}
LEAVES = r"(?:return|continue|break)\b"
WHOLE_NUMBER = re.compile(r"(?<![\w.<'])(?<!\de-)(\d)(?![\w.'>])")


def replaced(code, table):
    for old, new in table.items():
        at = code.find(old)
        while at >= 0:
            yield at, at + len(old), new
            at = code.find(old, at + 1)


def relational(code):
    yield from replaced(code, RELATIONS)


def min_max(code):
    yield from replaced(code, EXTREMES)


def deleted_guard(code):
    """A guard that leaves on its own line; one whose exit is in the next line never holds."""
    guard = re.match(r"(\s*)if \(", code)
    if not guard:
        return
    opening = guard.end() - 1
    closing = spans.matching(code, opening)
    if closing is None:
        return
    rest = code[closing + 1:].strip()
    if re.match(LEAVES, rest) and rest.endswith(";"):
        yield guard.end(1), len(code.rstrip()), "{}"
    elif not rest:
        yield opening + 1, closing, "(" + code[opening + 1:closing] + ") && false"


def dropped_term(code):
    for match in re.finditer(r" ([-+*/]) ", code):
        ends = spans.TERM_END if match.group(1) in "+-" else spans.FACTOR_END
        end = spans.end_of_operand(code, match.end(), ends)
        if end is not None and "~" not in code[match.start():end]:
            yield match.start(), end, ""
    for match in re.finditer(r" (&&|\|\|) ", code):
        end = spans.end_of_operand(code, match.end(), re.compile(r" && | \|\| | \? | : |[,;]"))
        if end is not None:
            yield match.start(), end, ""


def off_by_one(code):
    for match in re.finditer(r" [-+] 1(?![\w.'])", code):
        yield match.start(), match.end(), ""
    for match in WHOLE_NUMBER.finditer(code):
        yield match.start(), match.end(), str(int(match.group(1)) + 1)
    for match in re.finditer(r"(?<=\w)\[(\w+)\]", code):
        if not match.group(1).isdigit():
            yield match.start(1), match.end(1), f"{match.group(1)} - 1"


# No calls, and calls that do not know the order of their arguments.
NOT_SWAPPED = {"if", "for", "while", "switch", "catch", "max", "min", "minmax", "hypot", "swap"}


def swapped_arguments(code):
    for match in re.finditer(r"\b(\w+)\(", code):
        if match.group(1) in NOT_SWAPPED:
            continue
        found = spans.arguments(code, match.end() - 1)
        for (a, b), (c, d) in zip(found, found[1:]):
            if code[a:b] != code[c:d] and not re.match(r"(const )?[\w:<>]+&? \w+$", code[a:b]):  # a declaration
                yield a, d, code[c:d] + code[b:c] + code[a:b]


SUBTLE = {"relational": relational, "min max": min_max, "deleted guard": deleted_guard, "dropped term": dropped_term,
          "off by one": off_by_one, "swapped arguments": swapped_arguments}
