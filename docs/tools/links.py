#!/usr/bin/python3
"""Checks the built site: every relative link and its anchor exist, and nothing is loaded from another host.

    docs/tools/links.py build/docs

Prints PAGE: reason for each problem; the exit code is 1 if there is one. Links to other hosts are not followed, because the
site is built without a network. The pages that Doxygen made are not checked, only links to them.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

SKIPPED = ("api", "report", "run", "browser", "_downloads", "_static")
LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("source", "src")}


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.anchors = [], set()

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ("href", "src") and value:
                self.links.append((tag, name, value))
            if name in ("id", "name") and value:
                self.anchors.add(value)


def read(path):
    page = Page()
    page.feed(path.read_text(encoding="utf-8", errors="replace"))
    return page


def check(site):
    pages, problems = {}, []

    def parsed(path):
        if path not in pages:
            pages[path] = read(path)
        return pages[path]

    for path in sorted(site.rglob("*.html")):
        if path.relative_to(site).parts[0] in SKIPPED:
            continue
        for tag, name, value in parsed(path).links:
            parts = urlsplit(value)
            if parts.scheme or parts.netloc:
                if (tag, name) in LOADED and parts.scheme != "data":
                    problems.append(f"{path.relative_to(site)}: loads {value} from another host")
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            target = target / "index.html" if target.is_dir() else target
            if not target.exists():
                problems.append(f"{path.relative_to(site)}: there is no {value}")
            elif parts.fragment and target.suffix == ".html" and target.is_relative_to(site):
                inside = target.relative_to(site).parts[0] in SKIPPED
                if not inside and unquote(parts.fragment) not in parsed(target).anchors:
                    problems.append(f"{path.relative_to(site)}: {value} has no such anchor")
    return problems


def main():
    site = Path(sys.argv[1]).resolve()
    problems = check(site)
    for problem in problems:
        print(f"links: {problem}")
    print(f"links: {len(list(site.rglob('*.html')))} pages, {len(problems)} problems")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
