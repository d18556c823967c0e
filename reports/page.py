"""The evidence page: one HTML file with everything in it."""

import base64
import json
import platform
import shlex
from importlib.metadata import version
from pathlib import Path

import jinja2

import evidence

HERE = Path(__file__).parent


def embedded(picture):
    return "data:image/png;base64," + base64.b64encode(Path(picture).read_bytes()).decode()


def rows(manifest, found):
    """One row for each claim, in the order of claims.toml."""
    return [{"claim": c, "evidence": found[c.slug], "verdict": evidence.verdict(found[c.slug]),
             "figures": manifest.figures_of(c.slug)} for c in manifest.claims]


def pictures(manifest, data, drawing):
    return [{"figure": f, "picture": embedded(drawing.picture(f)),
             "commands": [shlex.join([r.program, *data.command(r)])
                          for r in drawing.runs(f)]} for f in manifest.figures]


def provenance(manifest, data):
    """(what, which): the program as its own results describe it, and what drew them."""
    for run in manifest.runs:
        summary = data.result(run) / "summary.json"
        if run.program == "tdbd" and summary.is_file():
            made = json.loads(summary.read_text(encoding="utf-8"))
            break
    else:
        made = {}
    program = [(k, made[k]) for k in ("version", "commit", "compiler", "flags") if k in made]
    drawn = [(name, version(name)) for name in ("numpy", "matplotlib", "netCDF4", "Jinja2")]
    return program + [("python", platform.python_version())] + drawn


def write(path, manifest, data, drawing, found, is_quick):
    """Writes the page, whole or not at all."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    html = environment.get_template("page.html.j2").render(
        rows=rows(manifest, found), pictures=pictures(manifest, data, drawing),
        provenance=provenance(manifest, data), is_quick=is_quick, not_measured=evidence.NOT_MEASURED)
    partial = Path(f"{path}.partial")
    partial.write_text(html, encoding="utf-8")
    partial.rename(path)
