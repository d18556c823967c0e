#!/usr/bin/python3
"""Tests docs/tools: pages whose output agrees pass; each kind of difference fails with page, line and reason; links and spelling."""

import contextlib
import io
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/tools"))
import links
import run_page
import spelling
import stage


def run(text, folder, write=False):
    """(failures, what is printed, the page afterwards) of a page with this text."""
    page, bins = folder / "page.md", folder / "bin"
    bins.mkdir(exist_ok=True)
    page.write_text(text, encoding="utf-8")
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        failures = run_page.run_all([page], folder / "work", bins, write, force=True)
    return failures, printed.getvalue(), page.read_text(encoding="utf-8")


def block(commands, option=""):
    return (f"<!-- run: {option} -->\n" if option else "\n") + f"```console\n{commands}\n```\n"


GOOD = {
    "equal": block("$ echo a 1.5\na 1.5"),
    "not stated": block("$ echo a"),
    "several": block("$ echo a\na\n$ echo b\nb"),
    "any lines": block("$ seq 5\n1\n...\n5"),
    "any text": block("$ echo took 3.7 s\ntook ... s"),
    "spaces": block("$ echo 'a   b'\na b"),
    "tolerance": block("$ echo x 1.0001\nx 1.0", "tolerance=1e-3"),
    "exit code": block("$ echo bad >&2; exit 2\nbad", "exit=2"),
    "continued": block("$ echo a \\\n  b\na b"),
    "not run": block("$ exit 1", "no, it would fail"),
    "a file": "<!-- file: d/a.txt -->\n```text\nhello\n```\n" + block("$ cat d/a.txt\nhello"),
    "other blocks": "```text\n$ exit 1\n```\n",
    "progress": block("$ printf '10 %%\\r100 %%\\rdone\\n'\ndone"),
}
# (page, line of the problem, reason)
BAD = {
    "another number": (block("$ echo x 1.0001\nx 1.0"), 4, 'found "x 1.0001", expected "x 1.0"'),
    "beyond the tolerance": (block("$ echo x 1.1\nx 1.0", "tolerance=1e-3"), 4, 'found "x 1.1"'),
    "another text": (block("$ echo b\na"), 4, 'found "b", expected "a"'),
    "too little": (block("$ echo a\na\nb"), 5, "found the end of the output"),
    "too much": (block("$ seq 2\n1"), 4, 'found more output, "2"'),
    "missing after ...": (block("$ seq 5\n...\n9"), 5, "found the end of the output"),
    "a failure": (block("$ echo why >&2; exit 3"), 3, "found exit code 3, expected 0: why"),
    "no failure": (block("$ true", "exit=2"), 3, "found exit code 0, expected 2"),
    "an unknown option": (block("$ true", "often"), 1, 'found "often", expected exit=N'),
    "a wrong option": (block("$ true", "exit=a"), 1, 'found "exit=a"'),
    "output first": (block("a\n$ echo a"), 3, "found output before the first command"),
    "no end": ("```console\n$ true\n", 1, "the block has no end"),
    "an outside file": ("<!-- file: ../a -->\n```text\n```\n", 1, "found the file ../a, expected a path inside"),
    "an open output": (block("$ true\n?"), 1, "the page has an output of ?"),
}


def check_runner(folder):
    for name, text in GOOD.items():
        failures, printed, _ = run(text, folder)
        assert failures == 0, (name, printed)
    for name, (text, line, reason) in BAD.items():
        failures, printed, _ = run(text, folder)
        assert failures == 1 and f"page.md:{line}: {reason}" in printed, (name, printed)
    assert "page.md:2: not run: it would fail" in run(GOOD["not run"], folder)[1]
    assert run(block("$ seq 2\n?"), folder, write=True)[2] == block("$ seq 2\n1\n2")


def check_stamp(folder):
    """A page that did not change is not run again; one that changed is."""
    page, bins = folder / "page.md", folder / "bin"
    page.write_text(block(f"$ echo x >> {folder}/count"), encoding="utf-8")
    for _ in range(2):
        with contextlib.redirect_stdout(io.StringIO()):
            run_page.run_all([page], folder / "work", bins)
    assert (folder / "count").read_text() == "x\n"
    page.write_text(page.read_text() + "more\n", encoding="utf-8")
    with contextlib.redirect_stdout(io.StringIO()):
        run_page.run_all([page], folder / "work", bins)
    assert (folder / "count").read_text() == "x\nx\n"


def check_links(folder):
    site = folder / "site"
    site.mkdir()
    (site / "b.html").write_text('<h1 id="top">b</h1>')
    good = '<a href="b.html">b</a> <a href="b.html#top">b</a> <a href="https://x.org/">x</a> <a href="#here" id="here">h</a>'
    (site / "a.html").write_text(good)
    assert links.check(site) == [], links.check(site)
    for bad, reason in (('<a href="c.html">c</a>', "there is no c.html"), ('<a href="b.html#no">b</a>', "has no such anchor"), ('<img src="no.png">', "there is no no.png"),
                        ('<script src="https://x.org/a.js"></script>', "from another host")):
        (site / "a.html").write_text(bad)
        found = links.check(site)
        assert len(found) == 1 and reason in found[0], (bad, found)


def check_prose():
    text = "A word.\n```text\ncode\n```\n`span` [text](link) $x$ <b>bold</b>\n<!-- no -->\n"
    assert spelling.WORD.findall(spelling.prose(text)) == ["A", "word", "text", "bold"], spelling.prose(text)
    assert spelling.prose(text).count("\n") == text.count("\n")


def linked_pages(page):
    """Pages of docs/ that a page links to, in its text or in a table of contents."""
    text = page.read_text(encoding="utf-8")
    names = re.findall(r"\]\(([^)#:\s]+)\.md(?:#[^)]*)?\)", text)
    for entries in re.findall(r"(?s)```\{toctree\}\n(.*?)```", text):
        names += re.findall(r"(?m)^(?:.*<)?([\w./-]+)>?$", entries)
    return {found for name in names if (found := (page.parent / f"{name}.md").resolve()).is_file()}


def check_clicks():
    """From the start page a tutorial or a how-to page takes one click, every other page at most two."""
    docs = ROOT / "docs"
    one = linked_pages(docs / "index.md")
    two = one.union(*(linked_pages(page) for page in one))
    for page in sorted(docs.rglob("*.md")):
        reached = one if page.parent.name in ("tutorials", "howto", "start") else two
        assert page in reached or page.name in ("README.md", "index.md"), f"no link from docs/index.md leads to {page.relative_to(ROOT)}"


def check_links_to_site():
    for link, expected in {"docs/howto/units.md": "../howto/units.md", "docs/index.md#x": "../index.md#x", "LICENSE": "LICENSE", "src/README.md": "src/README.md"}.items():
        assert stage.with_links_to_site("README.md", f"[a]({link})") == f"[a]({expected})", link
    assert stage.with_links_to_site("src/rock/README.md", "[a](../../docs/glossary.md)") == "[a](../../../glossary.md)"


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        check_runner(folder)
        check_stamp(folder)
        check_links(folder)
    check_prose()
    check_clicks()
    check_links_to_site()
    print("the runner of pages, the links and the spelling are checked")


if __name__ == "__main__":
    main()
