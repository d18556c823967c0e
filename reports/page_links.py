"""Links and tables of the report's pages: links of studies to files of the project, links that lead nowhere, tables that scroll."""

import html
import posixpath
import re
from pathlib import Path

from markupsafe import Markup

LINK = re.compile(r'<a href="([^"]*)">(.*?)</a>', re.DOTALL)
TARGET = re.compile(r'(?:href|src)="([^"]*)"')
IDENTITY = re.compile(r'\bid="([^"]*)"')
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:")  # data:, https:, mailto:


def in_boxes(text):
    """HTML whose tables scroll within their own boxes where the window is narrower than they are."""
    return Markup(str(text).replace("<table>", '<div class="wide" tabindex="0"><table>').replace("</table>", "</table></div>"))


def with_code(text):
    """Plain text as HTML, in which `names` between backticks are code."""
    return Markup(re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(str(text))))


def in_report(text, study, root, names):
    """The HTML of a study, whose links to studies lead to their pages and whose links to other files of the project are names of files.

    `names`: the studies that have pages. A link to a missing file is left as it is, so that `dead` reports it."""
    def link(found):
        target, words = found[1], found[2]
        path = (study.folder / target.partition("#")[0]).resolve()
        if ELSEWHERE.match(target) or not target.partition("#")[0] or not path.exists():
            return found[0]
        if path.name == "README.md" and path.parent.parent == study.folder.resolve().parent and path.parent.name in names:
            return f'<a href="{path.parent.name}.html">{words}</a>'
        return f"{words} (<code>{path.relative_to(Path(root).resolve())}</code>)"
    return Markup(LINK.sub(link, str(text)))


def dead(pages, folder):
    """Links that lead nowhere, as a list of problems. `pages`: {path relative to folder: HTML}, which need not be written yet;
    other targets must be files in the folder."""
    identities = {path: {html.unescape(i) for i in IDENTITY.findall(text)} for path, text in pages.items()}
    problems = []
    for page, text in pages.items():
        for target in sorted({html.unescape(t) for t in TARGET.findall(text)}):
            path, _, place = target.partition("#")
            if ELSEWHERE.match(target):
                continue
            path = posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page
            if path in pages and (not place or place in identities[path]):
                continue
            if path not in pages and not place and (Path(folder) / path).is_file():
                continue
            problems.append(f"{page}: found a link to {target}, expected " + (f"an element with the id {place} on {path}" if path in pages else "a file of the report"))
    return problems
