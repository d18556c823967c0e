"""Every figure and table of the thesis and its counterparts in TDBD: thesis_index.toml, compared with manifest.toml."""

import re
from dataclasses import dataclass
from pathlib import Path

from manifest import ManifestError, checked, load

ENTRY_KEYS = {"number": str, "title": str, "known": str, "instead": str, "counterpart": list, "why": str}
OPTIONAL = {"instead", "counterpart", "why"}
KNOWN = ("text", "title")  # the part of it that is available
NUMBER = re.compile(r"(figure|table) ([1-9]|[A-Z])\.([1-9][0-9]*)")
RANGE = re.compile(r"([1-9]|[A-Z])\.([1-9][0-9]*) to \1\.([1-9][0-9]*)")
REGENERATED, COUNTERPART, NOT_MADE = "regenerated", "counterpart", "not made"


@dataclass(frozen=True)
class Entry:
    number: str  # "figure 4.2"
    title: str
    known: str
    instead: str = ""
    counterpart: tuple = ()  # (kind, name)
    why: str = ""


@dataclass(frozen=True)
class Row:
    """The row of the page for one figure or table of the thesis."""

    entry: Entry
    status: str
    links: tuple  # (kind, name) of its counterparts
    words: str


def numbers(thesis):
    """The thesis numbers of a figure of the manifest: "4.17, 4.20", "B.9 to B.14"."""
    found = []
    for part in filter(None, (p.strip() for p in thesis.split(","))):
        span = RANGE.fullmatch(part)
        found += [f"{span[1]}.{k}" for k in range(int(span[2]), int(span[3]) + 1)] if span else [part]
    return found


def in_manifest(manifest):
    """{"figure 4.2": [names]} of the figures of the manifest that have a number of the thesis."""
    drawn = {}
    for f in manifest.figures:
        for number in numbers(f.thesis):
            drawn.setdefault(f"{f.kind()} {number}", []).append(f.name)
    return drawn


def entry_of(path, table):
    where = f"{path}, entry {table.get('number', '?')}"
    checked(where, table, ENTRY_KEYS, OPTIONAL)
    if not NUMBER.fullmatch(table["number"]):
        raise ManifestError(f"{where}: expected a number like \"figure 4.2\" or \"table A.1\"")
    if table["known"] not in KNOWN:
        raise ManifestError(f"{where}: known is {table['known']!r}, expected {' or '.join(KNOWN)}")
    values = dict(table)
    values["counterpart"] = tuple(tuple(c.split(" ", 1)) for c in table.get("counterpart", []))
    return Entry(**values)


def gaps(entries):
    """Problems of numbers that do not follow the previous number of their chapter."""
    last = {}
    for e in entries:
        kind, chapter, count = NUMBER.fullmatch(e.number).groups()
        expected = last.get((kind, chapter), 0) + 1
        if int(count) != expected:
            yield f"{e.number}: expected {kind} {chapter}.{expected} here"
        last[kind, chapter] = int(count)


def exists(root, manifest, kind, name):
    """Whether a counterpart exists. `missing` checks those that validation/chapter6 makes."""
    if kind == "chapter6":
        return True
    known = {"figure": {f.name for f in manifest.figures}, "claim": {c.slug for c in manifest.claims}}
    return (root / "reports/studies" / name).is_dir() if kind == "study" else name in known.get(kind, ())


def problems_of(entry, drawn, is_there):
    """The problems of one entry."""
    if (ways := (bool(drawn), bool(entry.counterpart), bool(entry.why))).count(True) != 1:
        sources = [w for w, has in zip((f"the manifest's {', '.join(drawn)}", "counterpart", "why"), ways) if has]
        yield f"found {' and '.join(sources) or 'nothing'}, expected one: a figure of manifest.toml, a counterpart, or why there is none"
    if entry.counterpart and not entry.instead:
        yield "found a counterpart without the key `instead`, which describes the difference"
    for c in entry.counterpart:
        if len(c) != 2 or not is_there(*c):
            yield f"there is no counterpart {' '.join(c)}"


def read(root, manifest):
    """The entries of reports/thesis_index.toml. Raises ManifestError if they are inconsistent with the manifest."""
    path = Path(root) / "reports/thesis_index.toml"
    entries = tuple(entry_of(path, t) for t in load(path)["entries"])
    drawn = in_manifest(manifest)
    problems = list(gaps(entries))
    known = {e.number for e in entries}
    problems += [f"{n}: manifest.toml draws it ({', '.join(names)}), but the thesis has no such number"
                 for n, names in drawn.items() if n not in known]
    for e in entries:
        there = lambda kind, name: exists(Path(root), manifest, kind, name)
        problems += [f"{e.number}: {p}" for p in problems_of(e, drawn.get(e.number, []), there)]
    if problems:
        raise ManifestError("\n".join(f"{path}: {p}" for p in problems))
    return entries


def missing(entries, made):
    """Counterparts of chapter 6 that its script does not make, as problems. `made`: the names that it made, or None if it did not run."""
    return [f"reports/thesis_index.toml: {e.number}: there is no counterpart chapter6 {name}"
            for e in entries for kind, name in e.counterpart
            if kind == "chapter6" and made is not None and name not in made]


def rows(entries, manifest):
    """A row for each entry. `manifest` is the complete one, so that --quick gives the same rows."""
    drawn = in_manifest(manifest)
    for e in entries:
        own = tuple(("figure", name) for name in drawn.get(e.number, []))
        counts_as = REGENERATED if own and not e.instead else COUNTERPART
        yield Row(e, NOT_MADE if e.why else counts_as, own or e.counterpart, e.why or e.instead)


def counts(found):
    """{kind: {status: count}} of rows."""
    found_counts = {}
    for row in found:
        of_kind = found_counts.setdefault(row.entry.number.split(" ")[0], {REGENERATED: 0, COUNTERPART: 0, NOT_MADE: 0})
        of_kind[row.status] += 1
    return found_counts
