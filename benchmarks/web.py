#!/usr/bin/python3
"""What drilling in a browser costs: size of the program, first picture, simulated over real seconds, and agreement with the command line.

    scripts/web && benchmarks/web.py TDBD build/web/web [--times 5] [--folder reports/studies/browser] [--only sensitivity]

TDBD: the program; then the folder of tdbd.js and tdbd.wasm. Writes cost.csv (Chromium, without a graphics card), agreement.csv (node) and
sensitivity.csv (the command line alone). Medians over the times.
"""

import argparse
import csv
import gzip
import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "verification/reports"), str(ROOT / "verification/web")]
import browser  # noqa: E402
import built  # noqa: E402

SENSITIVE = "drill-bit-r"  # grows differences: see the study
CASES = (*built.CASES, SENSITIVE)
WEIGHT, NUDGED = '"60 kN"', '"60.00000000000001 kN"'
WATCHED = 5.0  # s of drilling, after the first picture
PATIENCE = 60  # s


def opened(page):
    """(s to the first picture, simulated over real seconds) of one opening of the page, which drills bit B at 3 mm edges."""
    with browser.Browser(size=(1200, 1000)) as window:
        start = time.perf_counter()
        window.open(page)
        while not window.value("live.scene !== null && live.last !== null") and time.perf_counter() < start + PATIENCE:
            time.sleep(0.01)
        window.drawn()
        first = time.perf_counter() - start
        before, real = window.value("live.last.time_s"), time.perf_counter()
        while window.value("live.state") == "drilling" and time.perf_counter() < real + WATCHED:
            time.sleep(0.05)
        return first, (window.value("live.last.time_s") - before) / (time.perf_counter() - real)


def costs(wish):
    """Rows of cost.csv."""
    with tempfile.TemporaryDirectory() as made:
        page = Path(made) / "tdbd.html"
        subprocess.run([sys.executable, "-B", ROOT / "web/make.py", wish.web, "-o", page], check=True, capture_output=True)
        seen = [opened(page) for _ in range(wish.times)]
        size = page.stat().st_size
    packed = len(gzip.compress((wish.web / "tdbd.wasm").read_bytes(), 9))
    return [{"what": "program, gzipped", "found": packed / 1e6, "unit": "MB", "wanted": "at most 1"},
            {"what": "page, one file", "found": size / 1e6, "unit": "MB", "wanted": ""},
            {"what": "first picture after opening", "found": statistics.median(f for f, _ in seen), "unit": "s", "wanted": "at most 3"},
            {"what": "simulated over real time, bit B, 3 mm edges", "found": statistics.median(r for _, r in seen), "unit": "1", "wanted": "at least 1"}]


def processor_seconds(call):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    made = call()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return made, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def agreement(wish, name):
    """A row of agreement.csv."""
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        subprocess.run(["cp", "-r", ROOT / "cases", folder], check=True)
        case = folder / "cases/short.toml"
        case.write_text(built.shortened(ROOT, name), encoding="utf-8")
        native, web = [], []
        for _ in range(wish.times):
            native.append(processor_seconds(lambda: subprocess.run([wish.program, "run", case, "-o", folder / "out", "--quiet", "--force"], check=True))[1])
            look, seconds = processor_seconds(lambda: built.drilled(ROOT, wish.web, folder / "cases", "short.toml", 1_000_000, folder / "web.ply"))
            web.append(seconds)
        run = json.loads((folder / "out/summary.json").read_text(encoding="utf-8"))
        (points, triangles), (web_points, web_triangles) = built.surface(folder / "out/rock_final.ply"), built.surface(folder / "web.ply")
    volumes, same = np.array(list(run["removed_volume_by_part_m3"].values())), triangles == web_triangles
    apart = np.abs(np.array(look["removed_by_part_m3"]) - volumes).max() / volumes.max()
    return {"case": name, "steps": run["steps"], "triangles": look["triangles"], "same triangles": "yes" if same else "no",
            "vertices apart, m": float(np.abs(points - web_points).max()) if same else None, "volumes apart, relative": float(apart),
            "command line, s": statistics.median(native), "node, s": statistics.median(web)}


def volumes_of(wish, text):
    """Removed by each part, m3, in a case that the command line runs."""
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        subprocess.run(["cp", "-r", ROOT / "cases", folder], check=True)
        case = folder / "cases/short.toml"
        case.write_text(text, encoding="utf-8")
        subprocess.run([wish.program, "run", case, "-o", folder / "out", "--quiet"], check=True)
        return np.array(list(json.loads((folder / "out/summary.json").read_text(encoding="utf-8"))["removed_volume_by_part_m3"].values()))


def sensitivity(wish):
    """The row of sensitivity.csv: what the last digit of the weight does."""
    text = built.shortened(ROOT, SENSITIVE)
    assert WEIGHT in text
    as_it_is, nudged = volumes_of(wish, text), volumes_of(wish, text.replace(WEIGHT, NUDGED))
    apart = float(np.abs(nudged - as_it_is).max() / as_it_is.max())
    return {"case": SENSITIVE, "weight": WEIGHT.strip('"'), "nudged": NUDGED.strip('"'), "volumes apart, relative": apart}


def write(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, rows[0], lineterminator="\n")
        table.writeheader()
        for row in rows:
            table.writerow({k: f"{v:.3g}" if isinstance(v, float) else v for k, v in row.items()})
            print(row)


TABLES = {"cost": costs, "agreement": lambda wish: [agreement(wish, name) for name in CASES], "sensitivity": lambda wish: [sensitivity(wish)]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", type=Path, help="tdbd")
    parser.add_argument("web", type=Path, help="holds tdbd.js and tdbd.wasm")
    parser.add_argument("--times", type=int, default=5)
    parser.add_argument("--folder", type=Path, default=ROOT / "reports/studies/browser")
    parser.add_argument("--only", choices=list(TABLES), help="one of the tables")
    wish = parser.parse_args()
    for name in [wish.only] if wish.only else TABLES:
        write(wish.folder / f"{name}.csv", TABLES[name](wish))


if __name__ == "__main__":
    main()
