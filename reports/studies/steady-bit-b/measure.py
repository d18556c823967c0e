"""measure.py RESULT_FOLDER...: the data of this study from results of tdbd run.

Writes volumes.csv and runs.json beside this script. Wants a release build, for the self-intersections.
"""

import csv
import json
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
KEPT = ("commit", "compiler", "flags", "case_hash", "steps", "gage_radius_m", "volume_ledger_defect", "rock_triangles_start",
        "rock_triangles_end", "rock_quality_min", "rock_quality_1_percent")


def intersecting_pairs(folder):
    """Of the surface that the run left, by CGAL."""
    tool = HERE.parents[2] / "build/release/reference/tools/self-intersections"
    told = subprocess.run([tool, folder / "rock_final.ply"], capture_output=True, text=True, check=True).stdout
    return int(told.split("self-intersecting pairs")[1])


def main(folders):
    runs, volumes = {}, {}
    for folder in map(Path, folders):
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        case = tomllib.loads((folder / "case.toml").read_text(encoding="utf-8"))
        edge = f"{1e3 * case['rock']['edge_length']:g} mm"
        runs[edge] = {k: summary[k] for k in KEPT} | {"intersecting_pairs": intersecting_pairs(folder)} | {"motion": case["motion"]}
        volumes[edge] = summary["removed_volume_by_revolution_m3"]
    (HERE / "runs.json").write_text(json.dumps(runs, indent=1) + "\n", encoding="utf-8")
    with (HERE / "volumes.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["revolution", *(f"m3 at {edge}" for edge in runs)])
        for i, row in enumerate(zip(*volumes.values(), strict=True)):
            writer.writerow([i + 1, *row])


if __name__ == "__main__":
    main(sys.argv[1:])
