"""Tests and files that pages mention in backticks exist: `Suite.name`, `Suite.*`, `src/rock/cut/prism`."""

import re

import sources

FOLDERS = ("src", "reference", "verification", "benchmarks", "examples", "reports", "cases", "validation", "python", "docs", "README.md", "CONTRIBUTING.md")
CODE = re.compile(r"`([^`\n]+)`")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
TEST = re.compile(r"^\s*(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)\s*,\s*(\w+)", re.MULTILINE)
# A suite in CamelCase, or a name of so many words that it is no key of a case.
MENTIONED_TEST = re.compile(r"([A-Z](?=\w*[a-z])\w*)\.([a-z0-9_]+|\*)|(\w+)\.([a-z0-9]+(?:_[a-zA-Z0-9]+){4,})")
FILE_ENDINGS = ("md", "txt", "py", "cpp", "hpp", "toml", "json", "csv", "cff", "cmake", "ply", "stl", "nc")
PATH = re.compile(r"(?:src|reference|verification|benchmarks|cases|validation|reports|scripts|examples|cmake|python)/[\w./*-]+")
ENDINGS = ("", ".hpp", ".cpp", ".py", ".toml")


def check_test(word, tests):
    match = MENTIONED_TEST.fullmatch(word)
    if not match:
        return None
    suite, name = match.group(1) or match.group(3), match.group(2) or match.group(4)
    if name in FILE_ENDINGS or suite in tests and (name == "*" or name in tests[suite]):
        return None
    return f"no test is called {word}"


def check_path(word, files):
    """A path of a file, its ending left out or not, or of a folder; * stands for anything."""
    match = PATH.match(word)
    if not match or "NAME" in word or "..." in word:
        return None
    path = match.group(0).rstrip("/.")
    wanted = re.compile(re.escape(path).replace(r"\*", "[^/]*") + rf"(?:{'|'.join(map(re.escape, ENDINGS))})(?:/.*)?")
    return None if any(wanted.fullmatch(f) for f in files) else f"there is no {path}"


def check_text(path, text, tests, files):
    problems = []
    text = FENCE.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)
    for match in CODE.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        for why in (check_test(match.group(1), tests), check_path(match.group(1), files)):
            if why:
                problems.append(f"{path}:{line}: {why}")
    return problems


def all_tests():
    tests = {}
    for path in sources.tracked("verification"):
        for suite, name in TEST.findall(sources.without_comments(sources.read(path))):
            tests.setdefault(suite, set()).add(name)
    return tests


def check_all():
    tests, files = all_tests(), sources.tracked(".", suffixes=("",))
    pages = sources.tracked(*FOLDERS, suffixes=(".md",))
    return [p for page in pages for p in check_text(page, sources.read(page), tests, files)]


def self_test():
    tests = {"Prism": {"is_exact"}}
    files = ["src/rock/cut/prism.hpp", "src/rock/cut/prism.cpp", "cases/bit-b.toml", "README.md"]
    good = ["`Prism.is_exact`", "`Prism.*`", "`src/rock/cut/prism`", "`src/rock/cut/prism.hpp`", "`src/rock`", "`src/rock/`",
            "`cases/bit-*.toml`", "`motion.rate_of_penetration`", "`README.md`", "`reports/studies/NAME`", "`rock.hpp`",
            "```\n`Prism.was_exact`\n```", "src/nowhere is not in backticks", "`build/release/tdbd`", "`NAME.partial`"]
    bad = ["`Prism.was_exact`", "`Prisms.*`", "`prism.is_exact_for_all_prisms`", "`src/rock/prism`", "`src/rock/cut/prism.py`",
           "`cases/bit-c`", "`reference/rock`"]
    for text in good:
        assert not check_text("a.md", text, tests, files), text
    for text in bad:
        assert len(check_text("a.md", "\n" + text, tests, files)) == 1, text
        assert "a.md:2:" in check_text("a.md", "\n" + text, tests, files)[0], text


if __name__ == "__main__":
    sources.main(check_all, self_test)
