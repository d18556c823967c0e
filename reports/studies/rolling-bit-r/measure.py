"""measure.py RESULT_FOLDER: the data of this study from a result of tdbd run cases/bit-r-rolling.toml.

Writes cone_speeds.csv, rows.csv and run.json beside this script. Wants a release build, for the self-intersections.
"""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

import netCDF4

HERE = Path(__file__).resolve().parent
KEPT = ("commit", "compiler", "flags", "case_hash", "steps", "revolutions", "volume_ledger_defect", "rock_triangles_end",
        "rock_quality_min", "cones")


def intersecting_pairs(folder):
    """Of the surface that the run left, by CGAL."""
    tool = HERE.parents[2] / "build/release/reference/tools/self-intersections"
    told = subprocess.run([tool, folder / "rock_final.ply"], capture_output=True, text=True, check=True).stdout
    return int(told.split("self-intersecting pairs")[1])


def write(name, rows):
    with (HERE / name).open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


def speeds(folder, summary):
    """Means over every full revolution of the cones' speeds over the bit's."""
    with netCDF4.Dataset(folder / "history.nc") as history:
        angles, turned = history["cone_angle"][:], history["rotation_angle"][:]
    names = [cone["name"] for cone in summary["cones"]]
    rows, first = [["revolution", *names]], 0
    for revolution in range(1, int(summary["revolutions"]) + 1):
        last = next(i for i, angle in enumerate(turned) if angle >= 2.0 * math.pi * revolution - 1e-9)
        ratios = abs((angles[last] - angles[first]) / (turned[last] - turned[first]))
        rows.append([revolution, *(f"{ratio:.6f}" for ratio in ratios)])
        first = last
    return rows


def main(folder):
    folder = Path(folder)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    bit = json.loads((folder / "bit.json").read_text(encoding="utf-8"))
    write("cone_speeds.csv", speeds(folder, summary))
    write("rows.csv", [["cone", "row", "rolling_ratio"]] + [
        [cone["name"], i, row["rolling_ratio"]] for cone in bit["cones"] for i, row in enumerate(cone["rows"], 1)])
    (HERE / "run.json").write_text(json.dumps({k: summary[k] for k in KEPT} | {"intersecting_pairs": intersecting_pairs(folder)}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
