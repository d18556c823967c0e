"""quick_test.py ROOT BUILD: makes the quick report and looks at the page.

Every claim has a row with a verdict, every figure is embedded and points to what it shows; a second
call makes nothing.
"""

import pathlib
import re
import subprocess
import sys

import balance

root, build = map(pathlib.Path, sys.argv[1:])
sys.path.insert(0, str(root / "reports"))
import manifest  # noqa: E402
import page_links  # noqa: E402
import studies  # noqa: E402
from evidence import NOT_MEASURED, OPEN, VERDICTS  # noqa: E402

PICTURE = r'<img alt="[^"]+"(?: aria-describedby="[^"]+")? width="[0-9]+" src="data:image/(?:png|svg\+xml);base64,[A-Za-z0-9+/]{10000,}=*">'


def make():
    command = [sys.executable, "-B", root / "reports/make.py", "--quick", "--build", build]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


make()
assert "made" not in make(), "an unchanged report was made again"
page = (build / "report-quick/index.html").read_text(encoding="utf-8")
wanted = manifest.read(root / "reports", is_quick=True)
for claim in wanted.claims:
    row = re.search(rf'<tr class="claim" id="claim-{claim.slug}">.*?</tr>', page, re.DOTALL)
    assert row, claim.slug
    assert any(f">{v}</span>" in row[0] for v in [*VERDICTS, NOT_MEASURED, OPEN]), claim.slug
for figure in wanted.figures:
    block = re.search(rf'<figure id="figure-{figure.name}">.*?</figure>', page, re.DOTALL)
    assert block and re.search("<tbody>" if figure.form == "table" else PICTURE, block[0]), figure.name
    if figure.form == "svg":  # a surface would be a picture within the drawing
        assert "<image" not in (build / f"report-quick/figures/{figure.name}.svg").read_text(encoding="utf-8"), figure.name
    assert ("Reconstructed:" in block[0]) == bool(figure.reconstructed), figure.name
shown = studies.find(root)
pages = {"index.html": page}
for study in shown:
    assert f'href="studies/{study.name}.html"' in page, study.name
    section = (build / f"report-quick/studies/{study.name}.html").read_text(encoding="utf-8")
    assert "<td" in section or re.search(PICTURE, section), study.name
    balance.check(section)
    pages[f"studies/{study.name}.html"] = section
assert len(re.findall(PICTURE, page)) == sum(f.form != "table" for f in wanted.figures)
assert len(re.findall("<img ", page)) == len(re.findall('<img alt="[^"]+"', page)), "a picture without words"
contents = re.search(r'<nav aria-label="Contents">.*?</nav>', page, re.DOTALL)[0]
for figure in wanted.figures:
    assert contents.count(f'href="#figure-{figure.name}"') == 1, f"{figure.name} in the table of contents"
for chapter in {c.slug.split("/")[0] for c in wanted.claims}:
    assert f'href="#{chapter}"' in contents, chapter
for described in re.findall(r'aria-describedby="([^"]+)"', page):
    assert f'id="{described}"' in page, described
listed = page.split('id="thesis-index"')[1].split("</table>")[0]
assert "92 figures:" in listed and "11 tables:" in listed and listed.count("<tr><td>") == 103
assert page_links.dead(pages, build / "report-quick") == []
for name, text in pages.items():
    text = re.sub(r"<(pre|style|code).*?</\1>|src=\"data:[^\"]*\"", "", text, flags=re.DOTALL)
    assert "`" not in text, f"{name}: a backtick in {text[text.index('`') - 60:][:120]!r}"
    assert text.count("<table") == text.count('<div class="wide" tabindex="0"><table>'), f"{name}: a table that does not scroll"
screen = page[:page.index('<nav aria-label="Contents">')]
for verdict in ("hold", "hold with limits", "refuted"):
    assert re.search(rf"<b>[0-9]+</b>{verdict}</li>", screen), verdict
assert "Headline numbers" in screen and "within 0.07 %" in screen
for name in ("comparison", "chapter6", "measured"):  # the full report makes them
    section = re.search(rf'<h2 id="calibration-{name}">.*?<h2', page, re.DOTALL)
    assert section and "Not made in this run" in section[0], name
assert wanted.bit_pages
for name in wanted.bit_pages:
    assert f'href="bits/{name}.html"' in page and (build / f"report-quick/bits/{name}.html").is_file(), name
assert wanted.pages3d
for name in wanted.pages3d:
    assert f'href="3d/{name}.html"' in page and (build / f"report-quick/3d/{name}.html").is_file(), name
assert "Classes of appendix B and their counterparts" in page and "<code>part_pose</code>" in page
assert not re.search(r"(src|href)=.https?:", page), "the page fetches something"
balance.check(page)
print(f"{len(wanted.claims)} claims, {len(wanted.figures)} figures, {len(shown)} studies")
