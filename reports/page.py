"""The evidence page with a summary, its chapters, their claims and figures, and everything that it embeds; and the pages of studies."""

import base64
import json
import platform
import re
import shlex
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import jinja2
from markupsafe import Markup, escape

import calibrations
import class_table
import evidence
import page_links
import readme
import studies
import thesis_index
from drawing import DPI
from fingerprint import Stale
from manifest import ManifestError
from readme_rows import ROWS, Measured

HERE = Path(__file__).parent


# Begin of the slugs of its claims, chapter of the thesis as in "4.2", title.
CHAPTERS = (
    ("chapter1", "1", "Chapter 1: cones, tracking and whirl"),
    ("chapter2", "2", "Chapter 2: models and the drill string"),
    ("chapter3", "3", "Chapter 3: the bit"),
    ("chapter4", "4", "Chapter 4: the rock"),
    ("chapter5", "5", "Chapter 5: the integrator"),
    ("chapter6", "6", "Chapter 6: forces"),
    ("appendix-a", "A", "Appendix A: the bits"),
    ("appendix-b", "B", "Appendix B: diagrams of the program"),
    ("appendix-c", "C", "Appendix C: the force law, reconstructed"),
    ("appendix-d", "D", "Appendix D: other pairings of bits"),
    ("literature", "", "Force laws of the literature"),
    ("ours", "", "Our own claims"),
)
OURS = "ours"


@dataclass(frozen=True)
class Chapter:
    slug: str
    title: str
    claims: tuple
    figures: tuple  # of the manifest


def slug_of(figure):
    """The chapter of a figure: that of its first number in the thesis, else that of its first claim, else that of additions of TDBD."""
    for slug, number, _ in CHAPTERS:
        if number and any(n.split(".")[0] == number for n in thesis_index.numbers(figure.thesis)[:1]):
            return slug
    return next((c.split("/")[0] for c in figure.claims), OURS)


def chapters(manifest):
    """All chapters of which there is something, in their order. Raises ManifestError for a claim of none."""
    known = {slug for slug, _, _ in CHAPTERS}
    for c in manifest.claims:
        if c.slug.split("/")[0] not in known:
            raise ManifestError(f"reports/claims.toml: an orphan, the page has no chapter for {c.slug}; known are {', '.join(sorted(known))}")
    found = [Chapter(slug, title, tuple(c for c in manifest.claims if c.slug.split("/")[0] == slug),
                     tuple(f for f in manifest.figures if slug_of(f) == slug)) for slug, _, title in CHAPTERS]
    return [c for c in found if c.claims or c.figures]


def label(figure):
    """How a link names a figure: by its number in the thesis, else by its own name."""
    return f"{'table ' if figure.kind() == 'table' else ''}{figure.thesis or figure.name}"


# Letters in a picture are then as large as the text around it: they have 9 points, and CSS has 96 pixels an inch.
PIXELS_PER_INCH = 128
POINTS_PER_INCH = 72
MEDIA = {".png": "image/png", ".svg": "image/svg+xml"}


def shown_width(picture):
    """Width on the page in CSS pixels, from the picture's size in inches."""
    start = Path(picture).read_bytes()[:2000]
    if Path(picture).suffix == ".svg":
        return round(float(re.search(rb'width="([0-9.]+)pt"', start)[1]) / POINTS_PER_INCH * PIXELS_PER_INCH)
    return round(int.from_bytes(start[16:20], "big") / DPI * PIXELS_PER_INCH)


def breakable(name):
    """A test's name that may break after its words, not within them."""
    return Markup(re.sub(r"([._])", r"\1<wbr>", str(escape(name))))


def embedded(picture):
    return f"data:{MEDIA[Path(picture).suffix]};base64," + base64.b64encode(Path(picture).read_bytes()).decode()


def rows(manifest, found):
    """One row for each claim, in the order of claims.toml."""
    return [{"claim": c, "evidence": found[c.slug], "decides": evidence.deciding(found[c.slug]),
             "verdict": evidence.verdict(c, found[c.slug]), "figures": manifest.figures_of(c.slug)}
            for c in manifest.claims]


def picture_or_rows(figure, path):
    """What the page embeds of a figure, or the heads and rows of a table."""
    if figure.form == "table":
        return {"rows": json.loads(path.read_text(encoding="utf-8")), "picture": None, "width": None}
    return {"rows": None, "picture": embedded(path), "width": shown_width(path)}


def pictures(manifest, data, drawing):
    return [{"figure": f, **picture_or_rows(f, drawing.picture(f)),
             "tables": [(t, drawing.table(t)["test"]) for t in f.tables if drawing.table(t)],
             "pages3d": [g for g in f.runs if g in manifest.pages3d],
             "commands": [shlex.join([r.program, *data.command(r)]) for r in drawing.runs(f)]}
            for f in manifest.figures]


WORDS = {"holds": "hold", "holds with limits": "hold with limits", "refuted": "refuted", evidence.OPEN: "open: no test measures them",
         evidence.NOT_MEASURED: "not measured in this run"}


def source_of(number, claims, names):
    """(words, link) of where a number of the table of measurements comes from: its claim on the page, or the page of its study."""
    if isinstance(number, Measured):
        return "claim", f"#claim-{number.claim}" if number.claim in claims else None
    name = number.folder.rsplit("/", 1)[-1]
    return f"study {name}", f"studies/{name}.html" if name in names else None


def headlines(root, claims, names):
    """(what, value, sources) of the table of measurements, from reports/readme.json; none in a project without that
    file. `readme.problems` compares the file with the current evidence. `claims`, `names`: the claims and studies with a place to link to."""
    try:
        kept = readme.read_kept(root)
    except Stale:
        return []
    return [(row.what, row.value.format(*(kept[n.key()] for n in row.numbers)), list(dict.fromkeys(source_of(n, claims, names) for n in row.numbers)))
            for row in ROWS if all(n.key() in kept for n in row.numbers)]


def summary(shown, root, names):
    """What the first screen of the page states: the rows of each verdict, and the headline numbers. `shown`: of `rows`; `names`: of studies."""
    by_verdict = [(verdict, [r for r in shown if r["verdict"] == verdict]) for verdict in WORDS]
    return {"claims": len(shown), "measurements": sum(len(r["evidence"]) for r in shown), "words": WORDS,
            "by_verdict": [(verdict, found) for verdict, found in by_verdict if found or verdict in evidence.VERDICTS],
            "headlines": headlines(root, {r["claim"].slug for r in shown}, names)}


def study_pages(environment, made, root):
    """{path in the report: HTML} of each study: title, text, tables, figure."""
    names = {s.name for s in made.runs()}
    template, pages = environment.get_template("study_page.html.j2"), {}
    for s in made.runs():
        picture = made.figure(s)
        pages[f"studies/{s.name}.html"] = template.render(
            study=s, text=page_links.in_report(studies.as_html(s.text, studies.STUDY_LEVEL), s, root, names),
            table=page_links.in_report(made.table(s), s, root, names), picture=picture and embedded(picture), width=picture and shown_width(picture))
    return pages


def shown_sets(makers):
    """What the page shows of each set of comparisons and calibrations: title, what it is, its tables and figures."""
    return [{"set": s, "is_made": maker.is_made(s),
             "items": [{**i, "table": i["table"] and studies.as_html(calibrations.table_text(i)),
                        "width": i["picture"] and shown_width(i["picture"]), "picture": i["picture"] and embedded(i["picture"])}
                       for i in maker.items(s)]}
            for maker in makers for s in maker.found()]


def program(manifest, data):
    """(what, which) of the programs that made the results, from the results themselves: one that did
    not change may be of an earlier commit."""
    made = {}
    for run in manifest.runs:
        for name in ("summary.json", "convergence.json"):
            if (file := data.result(run) / name).is_file():
                summary = json.loads(file.read_text(encoding="utf-8"))
                for key in ("version", "commit", "compiler", "flags"):
                    made.setdefault(key, {}).setdefault(str(summary.get(key, "?")))
    return [(key, ", ".join(values)) for key, values in made.items()]


def provenance(manifest, data):
    """(what, which): what made the results, and what drew them."""
    drawn = [(name, version(name)) for name in ("numpy", "matplotlib", "netCDF4", "Jinja2", "Markdown")]
    return program(manifest, data) + [("python", platform.python_version())] + drawn


def thesis_rows(index, whole, manifest):
    """The rows of the list of the thesis's figures and tables, with where each link leads: None where --quick leaves it out."""
    shown = {f.name for f in manifest.figures}
    places = {"figure": "#figure-{}", "study": "studies/{}.html", "claim": "#claim-{}", "chapter6": "#calibration-chapter6"}
    return [{"row": row, "links": [(name, None if kind == "figure" and name not in shown else places[kind].format(name))
                                   for kind, name in row.links]} for row in thesis_index.rows(index, whole)]


def environment_of():
    """The templates of the report, with filters for names that may break, labels of figures and text with code."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters |= {"breakable": breakable, "label": label, "code": page_links.with_code}
    return environment


def write_whole(path, text):
    """Writes a file, whole or not at all."""
    partial = Path(f"{path}.partial")
    partial.parent.mkdir(parents=True, exist_ok=True)
    partial.write_text(text, encoding="utf-8")
    partial.rename(path)


def write(path, manifest, data, drawing, made, makers, found, thesis, is_quick):
    """Writes the pages of the studies, then the page of the report. `thesis`: the index of the thesis's figures, and the whole manifest.
    Raises Stale, without writing anything, if a link leads nowhere."""
    environment, shown = environment_of(), rows(manifest, found)
    pages = study_pages(environment, made, data.root)
    pages[path.name] = environment.get_template("page.html.j2").render(
        summary=summary(shown, data.root, {s.name for s in made.runs()}), chapters=chapters(manifest), rows=shown, pictures=pictures(manifest, data, drawing), studies=made.runs(),
        sets=shown_sets(makers),
        bits=manifest.bit_pages, animations=manifest.animations, pages3d=manifest.pages3d, classes=class_table.rows(data.root),
        thesis=thesis_rows(*thesis, manifest), thesis_counts=thesis_index.counts(thesis_index.rows(*thesis)),
        provenance=provenance(manifest, data), is_quick=is_quick, not_measured=evidence.NOT_MEASURED)
    if problems := page_links.dead(pages, path.parent):
        raise Stale("\n".join(problems))
    for old in (path.parent / "studies").glob("*.html"):
        old.unlink()
    for name, text in pages.items():
        write_whole(path.parent / name, text)
