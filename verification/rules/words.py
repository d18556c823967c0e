"""Phrases of a private dialect do not occur in documents, in comments of C++, Python, CMake and shell scripts, or in messages (strings of src).

PHRASES has a pattern for each, with the words to use. A pattern that a technical sentence needs as well is narrow: "to the bit" is
rejected only where it means bitwise identical. The folders in NOT_YET are exempt until they have been rewritten; the list only shrinks.
"""

import ast
import bisect
import io
import re
import tokenize

import citations
import sources

PHRASES = {
    r"\bask(s|ed|ing)?\b": "evaluates, queries, tests, requires",
    r"\btells\b|\btold\b|\btell(ing)?\b": "reports, returns, prints, states",
    r"(?<!thesis )(?<!paper )(?<!standard )(?<!issue )\bsays\b": "reports, returns, prints, states",
    r"\bh[au]ngs? on\b|\bhanging on\b": "depends on",
    r"\banew\b": "again, from scratch",
    r"\b(go|goes|going|went|gone) on\b": "continues, resumes",
    r"\|\s*holds\s*\|": "contains",
    r"\bheld (against|to)\b": "is compared with, must satisfy",
    r"\bwhat an? \w+ costs?\b": "run time of a step",
    r"\b(nobody|whoever|somebody|anybody)\b": "no code, users who, the caller",
    r"\bin vain\b|\bfor good\b(?! reason)": "without effect, permanently",
    r"\b(equal|same|identical|alike|agrees?|exact|exactly|down|back) to the bit\b|\bthe same bytes\b": "bitwise identical",
    r"\ba number or a reason\b": "a value, or why there is none",
    r"\bthe former ways?\b": "the previous behaviour",
    r"\bdraws? (a )?faults?\b|\bmutants? (lives?|dies?|died|lived)\b": "seed a fault; a mutant survives, is killed",
    r"\b(loose|tight)(er|est)? (tests?|tolerances?)\b": "tolerance too wide, within three times the observed error",
    r"\bstands?\b(?! (for|still|off|on (the|its|a)|up|alone|out|before the first table)\b)(?=( \w+)? (in|below|above|beside|there|at|before)\b)": "is",
    r"\bas (it|they) stands?\b": "unchanged",
    r"\bg[ia]ve?s? way\b|\bgiving way\b": "yields, complies",
    r"\bby hand\b": "manually, independently",
    r"\blikewise\b": "a full sentence",
    r"\bon offer\b": "available",
    r"\bin the place of\b|\bin its stead\b": "instead of",
    r"\bwhat (came|comes) of\b": "the result of",
    r"\bhears? (of|how|what)\b": "is called with, receives",
    r"\bgo(es)? away\b": "is removed, vanishes",
    r"\b(mistakes|problems|faults) are noted\b|\bnotes (mistakes|problems|faults)\b": "records",
    r"\b(ours|theirs)\b(?!/)": "in TDBD, in the thesis",  # ours/NAME is the name of a claim
}
# In documents only: elsewhere the words have other meanings.
IN_DOCUMENTS = {r"(?<!::)\brooms?\b(?! (for|to)\b)|\bthe house\b": "module, directory"}
DOCUMENTS, CODE, PYTHON, SCRIPTS = (".md",), (".cpp", ".hpp"), (".py",), ("CMakeLists.txt", ".cmake", ".sh")
NOT_YET = ()
# These contain the phrases as examples.
EXEMPT = ("verification/rules/words.py",)


def strings(code):
    """The string literals of a C++ source, each character in its place; includes are left out."""
    blank = lambda text: re.sub(r"[^\n]", " ", text)
    code = re.sub(r"(?<=\d)'(?=\d)", "_", re.sub(r"(?m)^\s*#.*$", lambda m: blank(m.group(0)), code))
    out, end = [], 0
    for match in sources.TOKEN.finditer(code):
        token = match.group(0)
        out.append(blank(code[end:match.start()]) + (token if token.startswith(('"', 'R"')) else blank(token)))
        end = match.end()
    return "".join(out) + blank(code[end:])


def python_prose(text):
    """The comments and docstrings of a Python source, line by line."""
    lines = [""] * (text.count("\n") + 2)
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            lines[token.start[0] - 1] = token.string
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node) is not None:
            first = node.body[0].lineno
            for i, line in enumerate(node.body[0].value.value.split("\n")):
                lines[first - 1 + i] = line
    return "\n".join(lines)


def hash_comments(text):
    """The comments of a shell script or a CMake file, line by line."""
    return "\n".join((re.search(r"(?:^|\s)#.*", line) or [""])[0] for line in text.split("\n"))


def unreleased(text):
    """The part of a changelog before the first release."""
    return re.split(r"(?m)^## (?!Unreleased)", text)[0]


def prose(path, text):
    """What the rule reads of a file, each line in its place."""
    if path.endswith(CODE):
        return [citations.comments(text)] + ([strings(text)] if path.startswith("src/") else [])
    if path.endswith(PYTHON):
        return [python_prose(text)]
    if not path.endswith(DOCUMENTS):
        return [hash_comments(text)]
    return [unreleased(text) if path == "CHANGELOG.md" else text]


def folded(part):
    """(the text with single spaces and without marks of comments, the offset of each of its lines): a phrase may continue in the next line."""
    part = re.sub(r"(?m)^[ \t]*(///?<?!?|\*|#)", "", part)
    text, starts = "", []
    for line in part.split("\n"):
        starts.append(len(text))
        text += "".join(word + " " for word in line.split())
    return text, starts


def check_text(path, text):
    problems = []
    phrases = {**PHRASES, **IN_DOCUMENTS} if path.endswith(DOCUMENTS) else PHRASES
    for part in prose(path, text):
        text, starts = folded(part)
        for pattern, instead in phrases.items():
            for match in re.finditer(pattern, text, re.IGNORECASE):
                problems.append(f'{path}:{bisect.bisect_right(starts, match.start())}: found "{match.group(0)}", expected other words: {instead}')
    return problems


def is_in(path, folder):
    return path == folder or path.startswith(folder + "/")


def check_all():
    files = sources.tracked(".", suffixes=DOCUMENTS + CODE + PYTHON + SCRIPTS) + sources.tracked("scripts", ".ci", suffixes=("",))
    problems = {f: check_text(f, sources.read(f)) for f in sorted(set(files)) if f not in EXEMPT}
    for name in NOT_YET:
        if not any(p for f, p in problems.items() if is_in(f, name)):
            print(f"{name} is clean: remove it from NOT_YET in verification/rules/words.py")
    return [p for f, found in problems.items() if not any(is_in(f, name) for name in NOT_YET) for p in found]


def self_test():
    bad = [("a.md", "The step asks the rock."), ("a.md", "It hangs\non the step."), ("src/a.cpp", "// computed anew"), ("src/a.cpp", "/// The run\n/// goes on."),
           ("src/a.cpp", 'f("nobody uses it");'), ("a.py", '"""What a step costs."""\n'), ("a.py", "a = 1  # by hand\n"), ("a.md", "equal to the bit"),
           ("a.md", "| file | holds |"), ("a.md", "the seed stands in the case"), ("a.md", "another room of src"), ("CHANGELOG.md", "## Unreleased\n\n- anew\n"),
           ("a.md", "It is held to 1 %."), ("a.md", "A loose tolerance."), ("a.md", "the rock gives way"), ("a.md", "ours is faster"),
           ("CMakeLists.txt", "set(a 1)  # by hand\n"), ("scripts/a", "# by hand\n"), ("a.md", "digits that read back to the bit"),
           ("src/a.cpp", "/// Mistakes are noted."), ("a.md", "What came of it."), ("a.md", "the law as it stands"), ("a.md", "The old files go away.")]
    good = [("a.md", "The torque is applied to the bit."), ("a.md", "F stands for the force."), ("a.md", "the thesis says so"), ("a.py", 'a = "asks"\n'),
            ("verification/a.cpp", 'f("asks");'), ("src/a.cpp", "int asks = 1;"), ("a.md", "room for ten values"), ("src/a.cpp", "// a room"),
            ("CHANGELOG.md", "## Unreleased\n\n- new\n\n## 1.0\n\n- anew\n"), ("a.md", "for good reasons"), ("a.md", "the bound holds for all n"),
            ("src/a.cpp", '#include "by hand"'), ("scripts/a", "echo by hand"), ("a.md", "Backup cutters stand behind it."), ("a.md", "`Underside::room`"),
            ("a.md", "from the top drive, through the string, to the bit."), ("a.md", "the rim hears nothing")]
    for path, text in bad:
        assert len(check_text(path, text)) == 1, (path, text, check_text(path, text))
    for path, text in good:
        assert not check_text(path, text), (path, text, check_text(path, text))
    assert check_text("a.md", "\n\nsomebody")[0].startswith("a.md:3: "), check_text("a.md", "\n\nsomebody")


if __name__ == "__main__":
    sources.main(check_all, self_test)
