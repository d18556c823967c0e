"""The evidence page, one HTML file: its chapters with the claims and figures of each, and everything that it embeds."""

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
import studies
import thesis_index
from drawing import DPI
from manifest import ManifestError

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


def shown_studies(made):
    """What the page shows of each study: title, text, table, figure."""
    return [{"study": s, "text": studies.as_html(s.text), "table": made.table(s),
             "picture": (figure := made.figure(s)) and embedded(figure), "width": figure and shown_width(figure)}
            for s in made.runs()]


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
    places = {"figure": "figure-{}", "study": "study-{}", "claim": "claim-{}", "chapter6": "calibration-chapter6"}
    return [{"row": row, "links": [(name, None if kind == "figure" and name not in shown else places[kind].format(name))
                                   for kind, name in row.links]} for row in thesis_index.rows(index, whole)]


def write(path, manifest, data, drawing, made, makers, found, thesis, is_quick):
    """Writes the page, whole or not at all. `thesis`: the index of the thesis's figures, and the whole manifest."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters |= {"breakable": breakable, "label": label}
    html = environment.get_template("page.html.j2").render(
        chapters=chapters(manifest), rows=rows(manifest, found), pictures=pictures(manifest, data, drawing), studies=shown_studies(made),
        sets=shown_sets(makers),
        bits=manifest.bit_pages, animations=manifest.animations, pages3d=manifest.pages3d, classes=class_table.rows(data.root),
        thesis=thesis_rows(*thesis, manifest), thesis_counts=thesis_index.counts(thesis_index.rows(*thesis)),
        provenance=provenance(manifest, data), is_quick=is_quick, not_measured=evidence.NOT_MEASURED)
    partial = Path(f"{path}.partial")
    partial.parent.mkdir(parents=True, exist_ok=True)
    partial.write_text(html, encoding="utf-8")
    partial.rename(path)
