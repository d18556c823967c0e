"""Reads the contents of the report, runs, figures and claims, from manifest.toml and claims.toml."""

import itertools
import tomllib
from dataclasses import dataclass, field, replace
from pathlib import Path

# Keys of each table; those that are not in OPTIONAL are required.
RUN_KEYS = {"command": str, "case": str, "program": str, "output": str, "arguments": list,
            "set": dict, "variants": list, "sweep": dict, "quick": dict}
QUICK_KEYS = {"arguments": list, "set": dict, "sweep": dict}
FIGURE_KEYS = {"name": str, "script": str, "thesis": str, "title": str, "shows": str,
               "reconstructed": str, "form": str, "runs": list, "tables": list, "sources": list, "claims": list, "quick": bool}
FORMS = ("png", "svg", "table")
CLAIM_KEYS = {"slug": str, "claim": str, "where": str, "open": str}
OPTIONAL = {"open", "program", "output", "arguments", "set", "variants", "sweep", "quick", "form", "runs", "tables", "sources"}


class ManifestError(Exception):
    """An error in the manifest. The message names the table and the key."""


@dataclass(frozen=True)
class Run:
    """One call of a program. `settings` are passed as --set KEY=VALUE."""

    group: str  # the name in the manifest; a sweep makes several runs of one group
    name: str
    command: str
    case: str  # relative to the root
    program: str  # relative to the build folder
    output: str  # "folder": the program has an option -o; "stdout": its output is stored in stdout.txt
    arguments: tuple = ()
    settings: dict = field(default_factory=dict, hash=False)


@dataclass(frozen=True)
class Figure:
    name: str
    script: str
    thesis: str  # number of the figure in the thesis; empty: an addition of TDBD
    title: str
    shows: str
    reconstructed: str  # the part that is reconstructed; may be empty
    form: str  # one of FORMS
    runs: tuple  # groups
    tables: tuple  # evidence tables
    sources: tuple  # patterns of files of the project that it is drawn from
    claims: tuple
    quick: bool  # --quick draws it

    def kind(self):
        """The kind by which the thesis numbers it."""
        return "table" if self.form == "table" else "figure"


@dataclass(frozen=True)
class Claim:
    slug: str
    claim: str
    where: str  # where the claim is made
    open: str = ""  # why no test measures it; empty if one does


@dataclass(frozen=True)
class Manifest:
    runs: tuple
    figures: tuple
    claims: tuple
    bit_pages: tuple = ()  # groups, each of one run of `tdbd bit --report`
    animations: tuple = ()  # groups, each of one run of `tdbd run` with frames
    pages3d: tuple = ()  # the same

    def pages(self):
        return set(self.bit_pages) | set(self.animations) | set(self.pages3d)

    def group(self, name):
        return [r for r in self.runs if r.group == name]

    def figures_of(self, slug):
        return [f for f in self.figures if slug in f.claims]


def checked(where, table, keys, optional=frozenset(OPTIONAL)):
    """Returns the table. Raises ManifestError if a key is unknown, missing or of the wrong type."""
    for key, value in table.items():
        if key not in keys:
            raise ManifestError(f"{where}: unknown key {key}; known are {', '.join(keys)}")
        if not isinstance(value, keys[key]):
            raise ManifestError(f"{where}: {key} is {value!r}, expected a {keys[key].__name__}")
    for key in keys:
        if key not in table and key not in optional:
            raise ManifestError(f"{where}: {key} is missing")
    return table


def text(value):
    return str(value).lower() if isinstance(value, bool) else str(value)


def name_of(group, settings):
    return "/".join([group, *(text(v).replace(" ", "") for v in settings.values())])


def runs_of(group, table, is_quick):
    """The run of a table, or one run for every variant and every combination of the values to sweep."""
    where = f"run {group}"
    checked(where, table, RUN_KEYS)
    quick = checked(f"{where}, quick", table.get("quick", {}), QUICK_KEYS) if is_quick else {}
    common = table.get("set", {}) | quick.get("set", {})
    sweep = table.get("sweep", {}) | quick.get("sweep", {})
    arguments = quick.get("arguments", table.get("arguments", []))
    for variant in table.get("variants", [{}]):
        for values in itertools.product(*sweep.values()):
            own = variant | dict(zip(sweep, values))
            yield Run(group, name_of(group, own), table["command"], table["case"],
                      table.get("program", "tdbd"), table.get("output", "folder"),
                      tuple(map(text, arguments)), common | own)


def figure_of(table):
    where = f"figure {table.get('name', '?')}"
    checked(where, table, FIGURE_KEYS)
    values = {"form": "png", "runs": [], "tables": [], "sources": [], "quick": True} | table
    if values["form"] not in FORMS:
        raise ManifestError(f"{where}: form is {values['form']!r}, expected one of {', '.join(FORMS)}")
    return Figure(**{k: tuple(v) if isinstance(v, list) else v for k, v in values.items()})


def demand_links(manifest):
    """Raises ManifestError if a figure names something that does not exist, a run is not shown, or a name occurs twice."""
    groups = {r.group for r in manifest.runs}
    slugs = [c.slug for c in manifest.claims]
    for names in ([f.name for f in manifest.figures], slugs):
        if doubled := {n for n in names if names.count(n) > 1}:
            raise ManifestError(f"twice: {', '.join(sorted(doubled))}")
    for key in ("bit_pages", "animations", "pages3d"):
        if missing := set(getattr(manifest, key)) - groups:
            raise ManifestError(f"{key}: no run {', '.join(sorted(missing))}")
    for f in manifest.figures:
        for missing in [r for r in f.runs if r not in groups] + [c for c in f.claims if c not in slugs]:
            raise ManifestError(f"figure {f.name}: no run or claim {missing}")
    if unused := groups - {r for f in manifest.figures for r in f.runs} - manifest.pages():
        raise ManifestError(f"no figure shows the runs {', '.join(sorted(unused))}")


def quick_part(manifest):
    """The manifest without the figures that --quick omits, and without the runs that only these show."""
    figures = tuple(f for f in manifest.figures if f.quick)
    shown = {r for f in figures for r in f.runs} | set(manifest.bit_pages) | set(manifest.pages3d)
    return replace(manifest, figures=figures, animations=(), runs=tuple(r for r in manifest.runs if r.group in shown))


def load(path):
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ManifestError(f"{path}: {error}") from error


def read(folder, is_quick=False):
    """Reads manifest.toml and claims.toml of a folder. Raises ManifestError."""
    document = load(Path(folder) / "manifest.toml")
    runs = [r for group, table in document["runs"].items() for r in runs_of(group, table, is_quick)]
    claims = [Claim(**checked(f"claim {t.get('slug', '?')}", t, CLAIM_KEYS))
              for t in load(Path(folder) / "claims.toml")["claims"]]
    manifest = Manifest(tuple(runs), tuple(map(figure_of, document["figures"])), tuple(claims),
                        tuple(document.get("quick_bit_pages" if is_quick else "bit_pages", [])),
                        tuple(document.get("animations", [])),
                        tuple(document.get("quick_pages3d" if is_quick else "pages3d", [])))
    demand_links(manifest)
    return quick_part(manifest) if is_quick else manifest
