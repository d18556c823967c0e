"""The chapters of the page, and its table of contents: claims and figures of each chapter of the thesis."""

from dataclasses import dataclass

from manifest import ManifestError
from thesis_index import numbers

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
    """The chapter of a figure: that of its first number in the thesis, else that of its first claim, else ours."""
    for slug, number, _ in CHAPTERS:
        if number and any(n.split(".")[0] == number for n in numbers(figure.thesis)[:1]):
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
