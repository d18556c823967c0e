#!/usr/bin/python3
"""Checks the spelling of the pages in docs/ with aspell and the words of docs/words.txt.

    docs/tools/spelling.py PAGE.md ...      --words prints the unknown words alone

Code, equations, links and HTML are left out. Prints PAGE:LINE: word; the exit code is 1 if there is one. Words with a capital
letter after the first, or with a digit, are names and are left out. Both British and American spelling are accepted in no
page: the dictionary is that of the United Kingdom, as in the other documents.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NOT_PROSE = [re.compile(pattern, flags) for pattern, flags in (
    (r"^(`{3,}|:{3,}).*?^\1", re.DOTALL | re.MULTILINE), (r"<!--.*?-->", re.DOTALL), (r"\$\$.*?\$\$", re.DOTALL), (r"\$[^$\n]+\$", 0), (r"`[^`]*`", 0),
    (r"\]\([^)]*\)", 0), (r"<[^>]*>", re.DOTALL), (r"https?://\S+", 0), (r"\{\w+\}", 0))]
WORD = re.compile(r"[A-Za-z]+(?:'[a-z]+)?")


def prose(text):
    for pattern in NOT_PROSE:
        text = pattern.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    return text


def unknown(words):
    known = {w.strip().lower() for w in (ROOT / "docs/words.txt").read_text(encoding="utf-8").split("\n") if not w.startswith("#")}
    listed = subprocess.run(["aspell", "list", "--lang=en_GB", "--ignore=1"], input="\n".join(sorted(words)), capture_output=True, text=True, check=True)
    return {w for w in listed.stdout.split() if w.lower() not in known and w.lower().removesuffix("s") not in known}


def main():
    pages = [Path(p) for p in sys.argv[1:] if not p.startswith("--")]
    found = {}
    for page in pages:
        for number, line in enumerate(prose(page.read_text(encoding="utf-8")).split("\n"), 1):
            for word in WORD.findall(line):
                if not re.search(r"[A-Z]", word[1:]):
                    found.setdefault(word.removesuffix("'s"), []).append((page, number))
    wrong = unknown(found)
    if "--words" in sys.argv:
        print("\n".join(sorted(wrong)))
        return
    for word in sorted(wrong):
        for page, number in found[word]:
            print(f"{page}:{number}: {word}")
    print(f"spelling: {len(pages)} pages, {len(wrong)} unknown words")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
