"""Equations are cited by module and number, "rock (7)", and a page of that module has an equation of this number.

An equation or a contract is numbered in src/MODULE/*.md, once: "(7)" at the end of its line in a code block, or at
the start of a paragraph or a list item, or alone in the first cell of a table row. A document outside the repository is not cited at all.
"""

import re

import sources

MODULES = ("core", "rotation", "mesh", "bit", "rock", "forces", "dynamics", "string", "simulation", "calibration", "sweep")
FOLDERS = ("src", "reference", "verification", "benchmarks", "examples", "reports", "cases", "validation", "cmake", "scripts", "README.md",
           "CONTRIBUTING.md", "CHANGELOG.md", "CMakeLists.txt")
CODE, TEXT = (".hpp", ".cpp"), (".md", ".py", ".toml", ".txt", ".j2", ".cmake")
NUMBER = r"\(\d+[a-z]?\)"
CITED = re.compile(rf"\b({'|'.join(MODULES)})`?\s+({NUMBER}(?:\s*(?:,|and|to|or)\s*{NUMBER})*)")
PARAGRAPH = re.compile(rf"(?:\*\*)?({NUMBER})(?=\W|$)")
ITEM = re.compile(rf"\s*(?:[-*+] |\d+\. )(?:\*\*)?({NUMBER})(?=\W|$)")
ROW = re.compile(rf"\|\s*({NUMBER})\s*\|")
AT_END = re.compile(rf"({NUMBER})\W*$")
# A document that is not in the repository: "section 4", where sections of the thesis have two
# numbers or more ("section 4.2") and other works are named ("Mechanics, section 37"); or an issue.
OUTSIDE = re.compile(r"(?<![,;\s])\s+sections?\s+\d+(?!\.?\d)|\b(?:the|this|first)\s+issue\b", re.IGNORECASE)
THIS_RULE = "verification/rules/citations.py"  # its self-test holds wrong citations on purpose


def comments(code):
    """The comments of a source alone, each character in its place."""
    blank = lambda text: re.sub(r"[^\n]", " ", text)
    code = re.sub(r"(?<=\d)'(?=\d)", "_", code)  # the separator of 10'000
    out, end = [], 0
    for match in sources.TOKEN.finditer(code):
        out.append(blank(code[end:match.start()]))
        token = match.group(0)
        out.append(token if token.startswith(("//", "/*")) else blank(token))
        end = match.end()
    return "".join(out) + blank(code[end:])


def prose(path, text):
    """The text of a file without code; marks of comments are blanks, so that a citation may continue in the next line."""
    if path.endswith(CODE):
        text = comments(text)
    return re.sub(r"(?m)^[ \t]*(///?<?!?|\*|#)", lambda m: " " * len(m.group(0)), text)


def numbered(text):
    """Numbers of equations and contracts in a page, in their order."""
    found, fenced, before = [], False, ""
    for line in text.split("\n"):
        if line.lstrip().startswith("```"):
            fenced = not fenced
            continue
        if fenced or line.startswith("    "):
            match = AT_END.search(line) or ITEM.match(line)
        else:
            match = ITEM.match(line) or ROW.match(line) or (not before.strip() and PARAGRAPH.match(line))
        if match:
            found.append(match.group(1))
        before = line
    return found


def check_pages(pages):
    """pages: {path: text} of all Markdown pages under src. Returns ({module: numbers}, problems)."""
    modules, problems = {module: set() for module in MODULES}, []
    for path, text in sorted(pages.items()):
        module = path.split("/")[1]
        for number in numbered(text) if module in modules else []:
            if number in modules[module]:
                problems.append(f"{path}: {module} {number} is numbered twice")
            modules[module].add(number)
    return modules, problems


def check_text(path, text, modules):
    problems = []
    text = prose(path, text)
    at = lambda match: f"{path}:{text.count(chr(10), 0, match.start()) + 1}"
    for match in CITED.finditer(text):
        module = match.group(1)
        for number in re.findall(NUMBER, match.group(2)):
            if number not in modules[module]:
                problems.append(f"{at(match)}: {module} {number} is cited, and no page of src/{module} numbers it")
    for match in OUTSIDE.finditer(text):
        line = at(re.compile(r"\S").search(text, match.start()))
        problems.append(f'{line}: "{" ".join(match.group(0).split())}" cites a document outside the repository')
    return problems


def check_all():
    pages = {p: sources.read(p) for p in sources.tracked("src", suffixes=(".md",))}
    modules, problems = check_pages(pages)
    for path in sources.tracked(*FOLDERS, suffixes=CODE + TEXT):
        if path != THIS_RULE:
            problems += check_text(path, sources.read(path), modules)
    return problems


def self_test():
    page = "# Rock\n\n    V = A h   (1)\n\n```\nx = y,  (2)\n```\n\n- (3) Contract.\n- **(4)** Another.\n\n(5) A paragraph.\n" \
           "(6) goes on with the paragraph.\n\n| (6) | a row |\n| (8), a claim | a test |\n\nProse that ends with rock (9)\nA list (10) of things.\n"
    assert numbered(page) == ["(1)", "(2)", "(3)", "(4)", "(5)", "(6)"], numbered(page)
    modules, problems = check_pages({"src/rock/README.md": page, "src/rock/cut/MORE.md": "    a   (7a)\n",
                                   "src/README.md": "(8) of no module\n"})
    assert not problems and "(7a)" in modules["rock"] and "(8)" not in modules["rock"]
    assert check_pages({"src/rock/README.md": page, "src/rock/cut/MORE.md": "    a   (3)\n"})[1]
    good = [("a.cpp", "// see rock (1), (2) and (3)"), ("a.cpp", "/// by rock\n/// (4) to (5)."), ("a.md", "`rock` (5)"),
            ("a.cpp", 'f("rock (99)");'), ("a.cpp", "int rock (99);"), ("a.md", "a rocky (99)"), ("a.md", "thesis 4.2, section 4.1.2, eq. 4.1"),
            ("a.md", "two sections, 3 tests"), ("a.cpp", "/// Mechanics,\n/// section 37."), ("a.md", "Report an issue"), ("a.py", "# rock (7a)")]
    bad = [("a.cpp", "// rock (9)"), ("a.cpp", "// rock (1) and\n// (9)"), ("a.cpp", "/* mesh (1) */"), ("a.md", "rock (7)"),
           ("a.cpp", "/// section 4"), ("a.cpp", "/// as Section\n/// 12 has it"), ("a.toml", "# as in sections 3 and 4"),
           ("a.cpp", "// the issue's number")]
    for path, text in good:
        assert not check_text(path, text, modules), (path, text)
    for path, text in bad:
        assert len(check_text(path, "\n" + text, modules)) == 1 and ":2:" in check_text(path, "\n" + text, modules)[0], (path, text)


if __name__ == "__main__":
    sources.main(check_all, self_test)
