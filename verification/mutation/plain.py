"""The plain operators: coarser faults. Each takes the code of a line and yields (from, to, new text)."""

import re

from subtle import replaced

ARITHMETIC = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * "}
ASSIGNMENT = {" += ": " -= ", " -= ": " += ", " *= ": " /= ", " /= ": " *= "}
LOGICAL = {" && ": " || ", " || ": " && "}
WORDS = {"true": "false", "false": "true", "break": "continue", "continue": "break"}
TWINS = {"std::sin(": "std::cos(", "std::cos(": "std::sin(", "std::floor(": "std::ceil(", "std::ceil(": "std::floor(",
         "lower_bound(": "upper_bound(", "upper_bound(": "lower_bound(", ".front()": ".back()", ".back()": ".front()",
         ".x()": ".y()", ".y()": ".z()", ".z()": ".x()", ".first": ".second", ".second": ".first",
         "std::any_of(": "std::all_of(", "std::all_of(": "std::any_of("}
DECIMAL = re.compile(r"(?<![\w.])(\d+\.\d+)(e-?\d+)?(?!\w)|(?<![\w.])(\d+)(e-?\d+)(?!\w)")
STATEMENT = re.compile(r"(\s*)(?!return\b|using\b|const\b|auto\b|break\b|continue\b|throw\b|case\b|if\b|for\b|while\b|else\b|goto\b)"
                       r"[\w:.\->\[\]*]+(?:\(.*\)| [-+*/|&]?= .*)?;$")


def arithmetic(code):
    yield from replaced(code, ARITHMETIC)


def assignment(code):
    yield from replaced(code, ASSIGNMENT)


def logical(code):
    yield from replaced(code, LOGICAL)
    for match in re.finditer(r"(?<![\w\]])!(?=[\w(])", code):
        yield match.start(), match.end(), ""


def words(code):
    for match in re.finditer(r"\b(true|false|break|continue)\b", code):
        yield match.start(), match.end(), WORDS[match.group(1)]


def sign(code):
    for match in re.finditer(r"(?:(?<=[(,{\[] )|(?<=[({\[])|(?<= = )|(?<=, )|(?<=\? )|(?<= : )|(?<=return ))-(?=[\w(])", code):
        yield match.start(), match.end(), ""


def twin(code):
    yield from replaced(code, TWINS)


def constant(code):
    """A number 1.3 times as large, 1 for 0; a tolerance (with an exponent) a thousand times."""
    for match in DECIMAL.finditer(code):
        value = float(match.group(0))
        has_exponent = match.group(2) or match.group(4)
        new = "1.0" if value == 0.0 else repr(float(f"{value * (1000.0 if has_exponent else 1.3):.6g}"))
        yield match.start(), match.end(), new


def deleted_statement(code):
    match = STATEMENT.fullmatch(code.rstrip())
    if match and ("(" in code or "=" in code or "++" in code) and not re.match(r"\s*[\w:<>]+ \w+(\(|;| = )", code):
        yield match.end(1), len(code.rstrip()), "{}"


PLAIN = {"arithmetic": arithmetic, "assignment": assignment, "logical": logical, "words": words, "sign": sign, "twin": twin,
         "constant": constant, "deleted statement": deleted_statement}
