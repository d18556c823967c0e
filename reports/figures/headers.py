"""Reads C++ headers: the types that they declare, with their fields, the free functions, and what they include.

For headers of this project, which declare plain structs and free functions in namespaces; it is no compiler.
"""

import re
from dataclasses import dataclass

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
STRING = re.compile(r'"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'')
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
TYPE = re.compile(r"\b(struct|class|enum class|enum)\s+(?:\[\[\w+\]\]\s*|alignas\([^)]*\)\s*)?(\w+)(?:\s+final)?(?:\s*:[^:].*)?$", re.DOTALL)
FUNCTION = re.compile(r"([~\w]+)\s*\($")
POINTER = re.compile(r"^(.*?)\(\s*\*\s*(\w+)\s*\)\s*\((.*)\)$", re.DOTALL)
ALIAS = re.compile(r"using\s+(\w+)\s*=\s*(.*)", re.DOTALL)
DROPPED = re.compile(r"\b(mutable|inline|constexpr|explicit|virtual)\b\s*|\[\[\w+\]\]\s*")
NO_FIELD = re.compile(r"^(using|friend|typedef|static|template|struct|class|enum|return)\b|^$|\boperator\b")


@dataclass(frozen=True)
class Type:
    name: str  # with the type around it: "Outer::Inner"
    kind: str  # "struct", "class", "enum" or "using"
    fields: tuple  # (name, type); of an enum (name, ""); of an alias ("", type)


@dataclass(frozen=True)
class Header:
    types: tuple
    functions: tuple  # names, each once
    included: tuple  # paths below src


def without(text):
    """The code without comments, strings and preprocessor lines."""
    text = STRING.sub('""', COMMENT.sub(" ", text))
    return re.sub(r"^[ \t]*#.*(?:\\\n.*)*$", "", text, flags=re.MULTILINE)


def words(text):
    """The names in a type: "mesh::Box", "vector"."""
    return re.findall(r"[A-Za-z_][\w:]*", text)


def closing(code, start):
    """Where the brace at `start` closes."""
    depth = 0
    for k in range(start, len(code)):
        depth += {"{": 1, "}": -1}.get(code[k], 0)
        if depth == 0:
            return k
    raise ValueError(f"an open brace: {code[start:start + 40]!r}")


def statements(code):
    """(head, body) of every statement: body is the text in its braces, or None where it ends in a semicolon."""
    head, k = "", 0
    while k < len(code):
        if code[k] == "{":
            end = closing(code, k)
            if is_value(head):  # an initial value is part of its statement
                head += "{}"
            else:
                yield head.strip(), code[k + 1:end]
                head = ""
            k = end
        elif code[k] == ";":
            yield head.strip(), None
            head = ""
        elif code[k] != "}":
            head += code[k]
        k += 1


def is_value(head):
    """Whether the brace after these words opens the value of a variable, not a body."""
    words = re.sub(r"\b(public|private|protected)\s*:", "", head).strip()
    if TYPE.search(words) or re.search(r"\b(namespace|extern)\b", words):
        return False
    return not re.search(r"\)\s*(const|noexcept|override|->[\w:<>\s]+)*\s*$|\)\s*:[^:].*$", words, re.DOTALL)


def squeezed(text):
    return re.sub(r"\s*([<>,&*])\s*", r"\1", re.sub(r"\s+", " ", text)).replace(",", ", ").replace("std::", "").strip()


def cut_at_depth_0(text, separator):
    """The pieces between separators that are in no brackets."""
    pieces, depth = [""], 0
    for character in text:
        depth += {"<": 1, "(": 1, "[": 1, "{": 1, ">": -1, ")": -1, "]": -1, "}": -1}.get(character, 0)
        if character == separator and depth == 0:
            pieces.append("")
        else:
            pieces[-1] += character
    return [p.strip() for p in pieces]


def fields_of(statement):
    """(name, type) of what a member statement declares; nothing of a function."""
    text = DROPPED.sub("", re.sub(r"\b(public|private|protected)\s*:", "", statement)).strip()
    if NO_FIELD.search(text):
        return []
    first, *more = (cut_at_depth_0(piece, "=")[0] for piece in cut_at_depth_0(text, ","))
    if pointer := POINTER.match(first):
        return [(pointer[2], squeezed(f"{pointer[1]}({pointer[3]})"))]
    if "(" in re.sub(r"<.*>", "", first):
        return []
    declared = re.match(r"^(.*[\s>&*])(\w+)\s*(\[[^\]]*\])?(?:\{\})?$", first, re.DOTALL)
    if not declared:
        return []
    names = [declared[2]] + [m.removesuffix("{}").strip(" *&\n") for m in more]
    return [(name, squeezed(declared[1]) + (declared[3] or "")) for name in names]


def types_of(kind, name, body):
    """The type and those declared in it."""
    if kind.startswith("enum"):
        values = [cut_at_depth_0(v, "=")[0] for v in cut_at_depth_0(body, ",")]
        return [Type(name, "enum", tuple((v, "") for v in values if v))]
    fields, inner = [], []
    for head, own in statements(body):
        found = TYPE.search(head)
        if own is not None and found:
            inner += types_of(found[1], f"{name}::{found[2]}", own)
        elif own is None:
            fields += fields_of(head)
    return [Type(name, kind, tuple(fields)), *inner]


def read_scope(code, types, functions):
    """Adds what a namespace declares."""
    for head, body in statements(code):
        found = TYPE.search(head)
        if body is not None and re.search(r"\bnamespace\b[^()=;]*$", head):
            read_scope(body, types, functions)
        elif body is not None and found:
            types += types_of(found[1], found[2], body)
        elif alias := ALIAS.fullmatch(head):
            types.append(Type(alias[1], "using", (("", squeezed(alias[2])),)))
        elif "(" in head and not re.match(r"(using|static_assert)\b", head) and "operator" not in head:
            before = cut_at_parameters(head)
            if (name := FUNCTION.search(before)) and "=" not in before:
                functions.append(name[1])


def cut_at_parameters(head):
    """Up to the parenthesis that opens the parameters: the first in no angle brackets."""
    depth = 0
    for k, character in enumerate(head):
        depth += {"<": 1, ">": -1}.get(character, 0)
        if character == "(" and depth == 0:
            return head[:k + 1]
    return ""


def includes(text):
    """What a header or a source includes of the project."""
    return tuple(INCLUDE.findall(COMMENT.sub(" ", text)))


def read(text):
    """The header of a text."""
    types, functions = [], []
    read_scope(without(text), types, functions)
    return Header(tuple(types), tuple(dict.fromkeys(functions)), includes(text))
