"""What the rule scripts share: the sources, comments taken out, the report, the self-test."""

import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'
                   r"'(?:\\.|[^'\\\n])+'", re.DOTALL)


def tracked(*folders, suffixes=(".hpp", ".cpp")):
    """Paths of the repository's files under the folders, relative to its root."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *folders],
        cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    files = sorted(f for f in listed if f.endswith(suffixes) and (ROOT / f).is_file())
    if not files:
        sys.exit("no sources found: a rule that looks at nothing proves nothing")
    return files


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def without_comments(text, keep_strings=False):
    """The code alone, line for line; strings and characters are emptied unless kept."""
    def blank(match):
        token = match.group(0)
        is_comment = token.startswith(("//", "/*"))
        if keep_strings and not is_comment:
            return token
        return (" " if is_comment else '""') + "\n" * token.count("\n")
    text = re.sub(r"(?<=\d)'(?=\d)", "", text)  # the separator of 10'000
    return TOKEN.sub(blank, text)


def main(check_all, self_test):
    """Runs the rule on the repository, or its self-test; exit code 1 when something is wrong."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--self-test", action="store_true")
    if parser.parse_args().self_test:
        prove(self_test)
    else:
        finish(check_all())


def prove(self_test):
    self_test()
    print("the rule turns red where it should")


def finish(problems):
    for problem in problems:
        print(problem)
    print(f"{len(problems)} problems")
    sys.exit(1 if problems else 0)
