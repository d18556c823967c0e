#!/usr/bin/python3
"""Updates the report: runs, figures, page. The exit code is 1 if something is stale.

    reports/make.py [--quick | --check | --evidence-only] [--build DIR] [--output DIR]

Repeats the runs and draws the figures whose inputs changed, with the program in the build folder, and
writes OUTPUT/index.html. With --check it only lists what is out of date.
"""

import argparse
import os
import sys
import time
from functools import partial
from pathlib import Path

import system_python

system_python.require("jinja2", "matplotlib", "numpy")

import bit_pages
import calibrations
import comparison
import evidence
import manifest as manifests
import page
import readme
import stated
import studies
import thesis_index
from data import Data
from drawing import Drawing
from fingerprint import Stale
from work import gather, gather_at_once

HERE = Path(__file__).resolve().parent


def report_time(update, subject):
    began = time.monotonic()
    if update(subject):
        print(f"made {subject.name} ({time.monotonic() - began:.1f} s)", flush=True)


def update(manifest, data, drawing, pages, others):
    """Runs and draws what changed. Returns problems. No figure is drawn if a run failed. `others` do not depend on runs of the
    manifest and take the longest time, so they start first."""
    runs = [r for r in manifest.runs if drawing.is_made(r)]
    problems = gather_at_once([(partial(report_time, o.update), r) for o in reversed(others) for r in o.runs()]
                              + [(partial(report_time, data.update), r) for r in runs])
    return problems or gather_at_once([(partial(report_time, p.update), r) for p in reversed(pages) for r in p.runs()]
                                      + [(partial(report_time, drawing.update), f) for f in manifest.figures])


def stale(manifest, data, drawing, pages):
    """Everything that is missing or was made from other inputs."""
    runs = [r for r in manifest.runs if drawing.is_made(r)]
    return (gather([(data.demand_current, r) for r in runs])
            or gather([(drawing.demand_current, f) for f in manifest.figures]
                      + [(p.demand_current, r) for p in pages for r in p.runs()]))


def sources(manifest, drawing, others, evidence_folder):
    """Files that the page shows: pictures, measurements, and products of studies, comparisons and calibrations."""
    return ([drawing.picture(f) for f in manifest.figures] + list(evidence_folder.rglob("*.json"))
            + [p for m in others for run in m.runs() for p in m.products(run)])


def stale_page(html, shown, studies_shown):
    """A problem if a page is missing, or the page of the report is older than one of the files that it shows, as a list."""
    for page_of in (html, *(html.parent / f"studies/{s.name}.html" for s in studies_shown)):
        if not page_of.is_file():
            return [f"{page_of}: has not been made"]
    newer = [s for s in shown if s.stat().st_mtime_ns > html.stat().st_mtime_ns]
    return [f"{html}: older than {newer[0]}"] if newer else []


def missing_counterparts(index, calibrated):
    """Counterparts of chapter 6 of the thesis that its script did not make. Empty if the script did not run."""
    made = {i["name"] for i in calibrated.items(calibrations.CHAPTER_6)}
    return thesis_index.missing(index, made or None)


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--quick", action="store_true", help="shorter cases; missing evidence is no error")
    mode.add_argument("--check", action="store_true", help="make nothing, list what is out of date")
    mode.add_argument("--evidence-only", action="store_true", help="only check whether the evidence is up to date")
    parser.add_argument("--root", type=Path, default=HERE.parent, help="where cases/ and reports/ are")
    parser.add_argument("--build", type=Path, help="build folder (build/release)")
    parser.add_argument("--output", type=Path, help="where the report goes (results/report)")
    chosen = parser.parse_args(arguments)
    chosen.build = (chosen.build or chosen.root / "build/release").resolve()
    default = chosen.build / "report-quick" if chosen.quick else chosen.root / "results/report"
    chosen.output = (chosen.output or default).resolve()
    return chosen


def report(chosen):
    """Makes or checks the report, depending on the arguments. Returns problems."""
    whole = manifests.read(chosen.root / "reports")
    index = thesis_index.read(chosen.root, whole)
    page.chapters(whole)  # raises if a claim belongs to no chapter
    manifest = manifests.read(chosen.root / "reports", chosen.quick)
    folder = Path(os.environ.get("TDBD_EVIDENCE") or chosen.build / "evidence")
    found = evidence.collect(folder, chosen.build, manifest.claims)
    unproved = found.wrong + ([] if chosen.quick else found.stale + readme.problems(chosen.root, found.by_claim))
    if chosen.evidence_only:
        tables = {t for f in manifest.figures for t in f.tables}
        return unproved + gather([(lambda t: evidence.table(folder, chosen.build, t), t)
                                  for t in sorted(tables)])
    unproved += stated.problems(chosen.root)
    data = Data(chosen.root, chosen.build, chosen.output / "data")
    drawing = Drawing(manifest, data, folder, chosen.output / "figures", chosen.quick)
    pages = [bit_pages.BitPages(manifest, data, chosen.output / "bits"),
             bit_pages.Animations(manifest, data, chosen.output / "moving"),
             bit_pages.Pages3d(manifest, data, chosen.output / "3d")]
    others = [made := studies.Studies(chosen.root, chosen.output / "studies"),
              calibrated := calibrations.Calibrations(chosen.root, chosen.build, chosen.output / "validation", chosen.quick),
              compared := comparison.Comparisons(chosen.root, chosen.build, chosen.output / "comparison", chosen.quick)]
    html = chosen.output / "index.html"
    if chosen.check:
        problems = stale(manifest, data, drawing, pages + others) or stale_page(html, sources(manifest, drawing, others, folder), made.runs())
        return problems + unproved + missing_counterparts(index, calibrated)
    html.unlink(missing_ok=True)
    problems = update(manifest, data, drawing, pages, others) or stale(manifest, data, drawing, pages + others)
    problems += unproved + missing_counterparts(index, calibrated)
    if not problems:
        page.write(html, manifest, data, drawing, made, (compared, calibrated), found.by_claim, (index, whole), chosen.quick)
        print(f"report: look at {html}")
    return problems


def main(arguments):
    try:
        problems = report(parse(arguments))
    except (manifests.ManifestError, Stale) as error:
        problems = [str(error)]
    for problem in problems:
        print(f"report: {problem}", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
