"""The qualified name of the function that each line of a source belongs to, without `tdbd` and unnamed namespaces.

A line of a class outside its functions has the name of the class, a line of a namespace that of the namespace. The names do not depend
on the file, so that a function may move to another one.
"""

import re

import lines

NAMESPACE = re.compile(r"\bnamespace\b\s*([\w:]*)\s*$")
CLASS = re.compile(r"\b(?:struct|class|union|enum(?:\s+(?:struct|class))?)\s+(?:\[\[.*?\]\]\s*)?((?:\w+::)*\w+)[^()=]*$")
# The name before the parameters: `Room::value`, `~Room`, `operator()`, `operator==`.
FUNCTION = re.compile(r"((?:\w+(?:<[^<>()]*>)?::)*(?:operator\s*(?:\(\)|[^\s\w(]+|\w[\w:&* ]*)|~?[A-Za-z_]\w*))\s*\(")
NO_FUNCTION = {"if", "for", "while", "switch", "catch", "return", "decltype", "noexcept", "alignas", "requires", "sizeof"}


def function_name(heading):
    """The name of the function that a heading declares; empty if it declares none."""
    for match in FUNCTION.finditer(heading):
        if match.group(1) not in NO_FUNCTION:
            return re.sub(r"\s+|<[^<>]*>(?=::)", "", match.group(1))
    return ""


def opened(heading):
    """(kind, name) of the scope that a brace after this heading opens; kind: namespace, class, function or value."""
    heading = re.sub(r"\[\[.*?\]\]|^.*?\b(?:public|private|protected):(?!:)", "", heading.strip(), flags=re.DOTALL)
    if match := NAMESPACE.search(heading):
        return "namespace", "::".join(name for name in match.group(1).split("::") if name != "tdbd")
    if match := CLASS.search(re.sub(r"^\s*template\s*<.*?>\s*(?=struct|class|union)", "", heading, flags=re.DOTALL)):
        return "class", match.group(1)
    name = function_name(heading)
    return ("function", name) if name else ("value", "")


def of_lines(text):
    """[name] of all lines of a source."""
    code = re.sub(r"(?m)^[ \t]*#.*$", lambda match: " " * len(match.group(0)), lines.blanked(text))
    names = [""] * (code.count("\n") + 1)
    scopes = []  # (kind, name, first line) of each open brace
    heading, heading_line, line, brackets = "", 0, 0, 0

    def qualified():
        return "::".join(name for _, name, _ in scopes if name) or "tdbd"

    for character in code:
        brackets += (character in "([") - (character in ")]")
        if character == "{":
            inside = brackets > 0 or any(kind in ("function", "value") for kind, _, _ in scopes)
            scopes.append((*(("value", "") if inside else opened(heading)), heading_line if heading.strip() else line))
        if character in "{}" and scopes and scopes[-1][0] == "function":
            names[scopes[-1][2]:line + 1] = [qualified()] * (line + 1 - scopes[-1][2])
        if character == "}" and scopes:
            scopes.pop()
        if character in "{};" and brackets <= 0:
            heading = ""
        elif heading.strip() or not character.isspace():
            heading_line = heading_line if heading.strip() else line
            heading += character
        if character == "\n":
            line += 1
        elif not character.isspace() and not names[line]:
            names[line] = qualified()
    return names
