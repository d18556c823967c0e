"""Which lines of a source may be mutated: statements, not comments, messages, tables of constants or hints.

A line is seen as `code`: comments and the insides of strings are blanked, so that columns stay those of the text.
"""

import re
from dataclasses import dataclass

TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
HINT = re.compile(r"^\s*#|\bstatic_assert\b|prefetch|[.>]reserve\(|^\s*(using|namespace|template|struct|class|enum|friend|case|default)\b"
                  r"|\[\[(no)?discard\]\]")
# A message: a string of several words, or any string beside one of these.
SENTENCE = re.compile(r'"[^"\n]* [^"\n]*"')
MESSAGE = re.compile(r"\bfmt::format|\bInputError|\bthrow\b|\bfail\(|[Ww]arn")
# A line of numbers, or a row that begins with its name.
TABLE = re.compile(r'^[\s{}(),;\d.eE+\-"~/*]*$|^\s*\{"')


@dataclass(frozen=True)
class Line:
    number: int  # from 1
    text: str
    code: str
    whole: bool = True  # a statement of its own


def blanked(text):
    """The text with comments and the insides of strings as spaces, column for column."""
    def blank(match):
        token = match.group(0)
        if token.startswith(("//", "/*")):
            return re.sub(r"[^\n]", " ", token)
        return token[0] + re.sub(r"[^\n]", "~", token[1:-1]) + token[-1]
    return TOKEN.sub(blank, text)


def statements(codes):
    """[(first, last)] of the statements, as indices of lines: each ends where ; { or } ends a line."""
    spans, first = [], 0
    for i, code in enumerate(codes):
        stripped = code.rstrip()
        if not stripped or stripped.endswith((";", "{", "}", ":")) or stripped.lstrip().startswith("#"):
            spans.append((first, i))
            first = i + 1
    if first < len(codes):
        spans.append((first, len(codes) - 1))
    return spans


def is_message(texts, codes):
    """Whether a statement puts a message together; a guard before it on a line of its own is no part of it."""
    return any(SENTENCE.search(text) for text, code in zip(texts, codes) if '"' in code) or (
        any('"' in code for code in codes) and any(MESSAGE.search(code) for code in codes))


def mutable(text):
    """The lines of a source that may be mutated."""
    texts, codes = text.split("\n"), blanked(text).split("\n")
    chosen = []
    for first, last in statements(codes):
        if is_message(texts[first:last + 1], codes[first:last + 1]):
            # The guard before a message on lines of its own may still be wrong.
            last = first if re.match(r"\s*(else )?if \(.*\)$", codes[first].rstrip()) and last > first else first - 1
        for i in range(first, last + 1):
            if codes[i].strip() and not HINT.search(codes[i]) and not TABLE.match(codes[i]):
                chosen.append(Line(i + 1, texts[i], codes[i], first == last == i))
    return chosen
