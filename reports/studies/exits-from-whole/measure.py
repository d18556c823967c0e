#!/usr/bin/python3
"""Does rock that leaves a cutter at once (update.exit_from = "whole") differ from rock that leaves its parts in turn
("parts")? Writes differences.csv and owners.csv beside itself. Wants a release build.

    measure.py                     all cases, some minutes
    measure.py --cases drill-bit-b only these; rows of other cases are kept
    measure.py --rounding          rounding.csv: what a millionth of the edge length does where forces move the bit
    measure.py --program PROGRAM   another build's tdbd

Every case is run three times: with both settings, and by parts with 0.7 times its edge length, for the mesh's own error.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import xarray

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "reports"))
from study_surfaces import distances, heights, read_ply  # noqa: E402

CELL, REACH = 0.25e-3, 0.107
FINER, NUDGED = 0.7, 1.000001  # times the edge length
EDGES = {"bit-r-rolling": 2.5}  # mm; 1.0 for the others
CASES = ["standard-workload", "bit-b-steady", "bit-a-steady", "bit-r-rolling", "bit-b-whirl", "drill-bit-b",
         "drill-bit-b-whirl"]
REVOLUTIONS = 3
LARGE = 0.01  # of the removed volume: cutters with less are too noisy to compare one by one


def drill(program, folder, case, edges, exit_from):
    out = pathlib.Path(folder) / f"{case}-{edges:.6f}-{exit_from}"
    text = (ROOT / f"cases/{case}.toml").read_text(encoding="utf-8")
    settings = [f"rock.edge_length='{edges:.6f} mm'", f"update.exit_from='{exit_from}'"]
    settings += [f"time.revolutions={REVOLUTIONS}" if "\nrevolutions" in text else "time.duration='1.5 s'"]
    command = [str(program), "run", str(ROOT / f"cases/{case}.toml"), "-o", str(out)]
    for setting in settings:
        command += ["--set", setting]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(result.stderr)
    return Run(out)


class Run:
    """What is compared of a result folder."""

    def __init__(self, folder):
        self.summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        with xarray.open_dataset(folder / "history.nc") as history:
            self.history = history.load()
        self.surface = heights(*read_ply(folder / "rock_final.ply"), REACH, CELL)
        self.volumes = by_cutter(self.summary["removed_volume_by_part_m3"])


def by_cutter(by_part):
    sums = {}
    for part, volume in by_part.items():
        name = part.partition("/")[0]
        sums[name] = sums.get(name, 0.0) + volume
    return sums


def last_half(run, name):
    """Sums over the second half of the run, one for each part or cutter."""
    if name not in run.history:
        return None
    values = run.history[name].values
    return np.nansum(values[values.shape[0] // 2:], axis=0)


def totals(run):
    """{quantity: number}; those that a case does not have are left out."""
    s, h = run.summary, run.history
    found = {"removed volume, cm3": 1e6 * s["removed_volume_m3"]}
    for name, key, scale in [("contact area, mm2", "contact_area_total", 1e6), ("section area, mm2", "section_area_total", 1e6)]:
        if (sums := last_half(run, key)) is not None:
            found[name] = scale * float(sums) / (h.sizes["time"] - h.sizes["time"] // 2)
    for name, key, scale in [("weight on bit, kN", "wob_mean_n", 1e-3), ("torque on bit, N m", "tob_mean_n_m", 1),
                             ("rate of penetration, m/h", "rop_mean_m_per_s", 3600), ("imbalance", "imbalance", 1)]:
        if isinstance(s.get(key), float) and s[key] != 0.0 and s.get("wob_mean_n"):
            found[name] = scale * s[key]
    found["moves a step"] = float(h["swept_vertices"].mean())
    found["triangles at the end"] = s["rock_triangles_end"]
    found["worst quality"] = s["rock_quality_min"]
    found["1 % quality"] = s["rock_quality_1_percent"]
    found["bisections"] = s["maintenance"]["bisections"]
    found["ledger's defect"] = s["volume_ledger_defect"]
    return found


def greatest_change(a, b, weights):
    """The greatest relative change of those that are large."""
    large = weights > LARGE * weights.sum()
    return float(np.max(abs(b[large] / a[large] - 1), initial=0.0))


def spreads(a, b):
    """{quantity: its greatest relative change between two runs}."""
    found = {"volume of a cutter, greatest change": greatest_change(
        np.array(list(a.volumes.values())), np.array(list(b.volumes.values())), np.array(list(a.volumes.values())))}
    for name, key in [("contact area of a part, greatest change", "contact_area"),
                      ("section area of a cutter, greatest change", "section_area")]:
        x, y = last_half(a, key), last_half(b, key)
        if x is not None and x.sum() > 0:
            found[name] = greatest_change(x, y, x)
    return found


def percent(x):
    return f"{100 * x:+.3g} %"


def rows_of(case, parts, whole, finer):
    rows = []
    before, after, fine = totals(parts), totals(whole), totals(finer)
    for q, x in before.items():
        is_zero = abs(x) < 1e-12
        rows.append([case, q, f"{x:.6g}", f"{after[q]:.6g}", "" if is_zero else percent(after[q] / x - 1),
                     "" if is_zero else percent(fine[q] / x - 1)])
    mesh = spreads(parts, finer)
    rows += [[case, q, "", "", percent(x), percent(mesh[q])] for q, x in spreads(parts, whole).items()]
    for q, pick in [("mean", np.mean), ("95th percentile", lambda d: np.percentile(d, 95)), ("greatest", np.max)]:
        apart = [1e3 * pick(distances(parts.surface, r.surface, REACH, CELL, 2e-3, 0.106)) for r in (whole, finer)]
        rows.append([case, f"distance of surfaces, {q}, mm", "", "", f"{apart[0]:.3g}", f"{apart[1]:.3g}"])
    return rows


def owners_of(case, parts, whole):
    """Who owns the volume: shares of kinds of part, %."""
    rows = []
    kinds = [str(k) for k in parts.history["part_kind"].values]
    for kind in dict.fromkeys(kinds):
        shares = []
        for run in (parts, whole):
            volumes = list(run.summary["removed_volume_by_part_m3"].values())
            shares.append(100 * sum(v for v, k in zip(volumes, kinds, strict=True) if k == kind) / sum(volumes))
        if max(shares) > 0:
            rows.append([case, kind, *(f"{s:.1f}" for s in shares)])
    return rows


def write(path, headings, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([headings, *rows])


def rows_kept(path, measured):
    """Rows of the cases that were not measured, if the file exists."""
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return [row for row in list(csv.reader(file))[1:] if row[0] not in measured]


def replace(path, headings, rows, measured):
    """Writes the rows of the measured cases among those of the others, in the order of CASES."""
    together = rows_kept(path, measured) + rows
    write(path, headings, sorted(together, key=lambda row: CASES.index(row[0])))


HEADINGS = ["case", "quantity", "parts", "whole", "change from parts to whole", "change with 0.7 times the edges"]
NUDGED_HEADINGS = ["case", "quantity", "parts", "1.000001 times the edges", "change with 1.000001 times the edges",
                   "change with 0.7 times the edges"]


def runs_of(program, case, others):
    """A case by parts, and as others say: times the edge length, exits from."""
    edges = EDGES.get(case, 1.0)
    with tempfile.TemporaryDirectory() as folder:
        return [drill(program, folder, case, f * edges, x) for f, x in [(1.0, "parts"), *others]]


def measure_rounding(program, out):
    rows = []
    for case in CASES:
        if case.startswith("drill-"):
            rows += rows_of(case, *runs_of(program, case, [(NUDGED, "parts"), (FINER, "parts")]))
    write(out / "rounding.csv", NUDGED_HEADINGS, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", nargs="*", default=CASES)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/tdbd")
    parser.add_argument("--out", type=pathlib.Path, default=HERE)
    parser.add_argument("--rounding", action="store_true")
    arguments = parser.parse_args()
    if arguments.rounding:
        return measure_rounding(arguments.program, arguments.out)
    differences, owners = [], []
    for case in arguments.cases:
        parts, whole, finer = runs_of(arguments.program, case, [(1.0, "whole"), (FINER, "parts")])
        differences += rows_of(case, parts, whole, finer)
        owners += owners_of(case, parts, whole)
        print(case, flush=True)
    replace(arguments.out / "differences.csv", HEADINGS, differences, arguments.cases)
    replace(arguments.out / "owners.csv", ["case", "kind of part", "share by parts, %", "share by whole, %"], owners, arguments.cases)


if __name__ == "__main__":
    main()
