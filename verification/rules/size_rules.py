"""Files of at most 400 lines, functions of at most 60: what a reader can hold in mind."""

import re

import sources

FILE_LINES, FUNCTION_LINES = 400, 60
# A brace after one of these opens no function.
NO_FUNCTION = re.compile(r"\b(namespace|struct|class|enum|union|extern)\b[^()]*$|[=,(]$|\breturn$")
STATEMENT = re.compile(r"(if|for|while|switch|else|do|try|catch)\b")


def skeleton(code):
    """The code without preprocessor lines, access labels and braced values, line for line."""
    code = re.sub(r"^[ \t]*#.*$", "", code, flags=re.MULTILINE)
    code = re.sub(r"\b(public|private|protected)\s*:", ";", code)
    value = re.compile(r"(\)(?:\s|const|noexcept|override)*)?\{[^{};]*\}")
    replaced = 1
    while replaced:  # an empty body ends its function; any other braces without ; are a value
        code, replaced = value.subn(
            lambda m: (m.group(1) + ";" if m.group(1) else "") + "\n" * (
                m.group(0).count("\n") - (m.group(1) or "").count("\n")), code)
    return code


def function_lengths(code):
    """(first line, lines) of every outermost function: the brace after a parameter list."""
    code = skeleton(code)
    lengths, braces, heading = [], [], ""
    line = heading_line = 1
    inside = None  # depth of the function that we are in
    for character in code:
        if character == "{":
            braces.append(heading_line)
            head = heading.strip()
            if (inside is None and ")" in head and not NO_FUNCTION.search(head)
                    and not STATEMENT.match(head)):
                inside = len(braces)
        elif character == "}" and braces:
            if inside == len(braces):
                lengths.append((braces[-1], line - braces[-1] + 1))
                inside = None
            braces.pop()
        if character in "{};":
            heading = ""
        elif heading.strip() or not character.isspace():
            heading_line = line if not heading.strip() else heading_line
            heading += character
        line += character == "\n"
    return lengths


def check_text(path, text):
    problems = []
    count = text.count("\n")
    if count > FILE_LINES:
        problems.append(f"{path}:{count}: {count} lines, at most {FILE_LINES} are allowed")
    for first, length in function_lengths(sources.without_comments(text)):
        if length > FUNCTION_LINES:
            problems.append(f"{path}:{first}: a function of {length} lines, at most "
                            f"{FUNCTION_LINES} are allowed")
    return problems


def check_all():
    files = sources.tracked("src", "reference", "benchmarks", "python")
    return [p for f in files for p in check_text(f, sources.read(f))]


def self_test():
    body = lambda n: "  if (x > '{') { x = f({1, 2}); }  // }\n" * n
    function = lambda n: "int f(int a,\n      int b) {\n" + body(n - 3) + "}\n"
    method = lambda n: "struct S : T<int> {\n  int a = 0;\n  int f() const {\n" + body(n - 2) + "  }\n};\n"
    for make in (function, method):
        assert not check_text("a.cpp", "namespace a {\n" + make(60) + "}\n"), make
        red = check_text("a.cpp", "namespace a {\n" + make(61) + "}\n")
        assert len(red) == 1 and "61 lines" in red[0], red
    for code, lengths in {
            "#include <a>\ntemplate <class F>\nvoid f(F g) noexcept {\n  g();\n}\n": [(2, 4)],
            "void f() { g(); }\n\nint h() { return 1; }\n": [(1, 1), (3, 1)],
            "A::A(int b) : b_{b}, c_(b) {\n  g();\n}\n": [(1, 3)],
            "const int a[]{\n1,\n2};\nint f() {}\nint g() {\n  return 1;\n}\n": [(5, 3)],
            "class A {\n public:\n  int f() { return 1; }\n};\n": [(3, 1)],
            "const auto f = [](int a) {\n  return S{a, {1}};\n};\n": [(1, 3)]}.items():
        assert function_lengths(code) == lengths, (code, function_lengths(code))
    assert not check_text("a.cpp", "int a;\n" * 400)
    assert check_text("a.cpp", "int a;\n" * 401)


if __name__ == "__main__":
    sources.main(check_all, self_test)
