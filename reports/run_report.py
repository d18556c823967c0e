#!/usr/bin/python3
"""Makes a printable page of a result: one HTML file with its numbers and pictures. `tdbd report` calls this script.

    reports/run_report.py FOLDER [-o FILE]      FOLDER/report.html
    reports/run_report.py NAME.nc [-o FILE]     NAME_report.html

FOLDER is a result of tdbd run, rotate, string, converge, calibrate, curve or tdbd bit --report (of which bit_page.py makes the page);
NAME.nc is the table of tdbd sweep.
Exit code 2 and a message for anything else.
"""

import argparse
import base64
import io
import os
import sys
import warnings
from pathlib import Path

import system_python

system_python.require("jinja2", "matplotlib", "numpy", "netCDF4")

import jinja2
import matplotlib

matplotlib.use("Agg")

import result_kind
import result_pictures
import run_facts
from progress import Progress

HERE = Path(__file__).resolve().parent
KINDS = ("run", "rotation", "string", "convergence", "calibration", "bit", "curve", "sweep")
DPI = 130  # of pictures: sharp on paper at the width of the page
TITLES = {"run": "A drilling run", "rotation": "A rotating body", "string": "A drill string", "convergence": "A study of convergence",
          "calibration": "A calibration", "curve": "A curve of rate over weight", "sweep": "A parameter study"}


def embedded(figure):
    """A figure as a data URL. The same figure gives a bitwise identical URL."""
    file = io.BytesIO()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of a layout that has no room
        figure.savefig(file, format="png", dpi=DPI, metadata={"Software": None})
    return "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()


def settings(folder):
    """The resolved case, or nothing."""
    case = folder / "case.toml"  # a table of a sweep has none
    return case.read_text(encoding="utf-8") if case.is_file() else ""


def html_of(folder, kind):
    """The page. Raises ValueError, LookupError."""
    summary, pictures = result_pictures.of_folder(folder, kind)
    drawn = [{"title": p.title, "caption": p.caption, "image": embedded(p.draw())}
             for p in Progress("report", len(pictures), "picture").over(pictures, lambda p: p.name)]
    listed, heads, rows = run_facts.table(kind, summary)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
                                     undefined=jinja2.StrictUndefined, lstrip_blocks=True)
    return environment.get_template("run_report.html.j2").render(
        title=summary.get("title") or folder.resolve().name, kind=TITLES[kind], facts=run_facts.FACTS[kind](summary),
        warnings=summary.get("warnings", []), pictures=drawn, listed=listed, heads=heads, rows=rows, settings=settings(folder),
        provenance=run_facts.provenance(summary))


def write_whole(path, text):
    """Writes a file completely or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = Path(f"{path}.partial")
    partial.write_text(text, encoding="utf-8")
    os.replace(partial, path)


def write(folder, path):
    """Writes the page of a result folder. Raises OSError, LookupError, ValueError."""
    kind = result_kind.demand(folder, KINDS)
    if kind == "bit":
        import bit_page  # here: its module for VTK files is not needed for other pages

        bit_page.write(folder, path)
    else:
        write_whole(path, html_of(folder, kind))


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="a result folder, or the table NAME.nc of a sweep")
    parser.add_argument("-o", "--output", type=Path, help="the page (FOLDER/report.html, or NAME_report.html)")
    chosen = parser.parse_args(arguments)
    table = chosen.folder.suffix == ".nc"
    path = chosen.output or (chosen.folder.with_name(f"{chosen.folder.stem}_report.html") if table else chosen.folder / "report.html")
    try:
        write(chosen.folder, path)
    except ImportError as error:
        print(f"report: found a Python without {error.name}, expected it after bash scripts/setup", file=sys.stderr)
        return 2
    except (OSError, LookupError, ValueError) as error:
        words = error if isinstance(error, (OSError, ValueError)) else f"{chosen.folder}: found a result without {error}"
        print(f"report: {words}", file=sys.stderr)
        return 2
    print(f"report: {path.stat().st_size / 1e6:.1f} MB; look at {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
