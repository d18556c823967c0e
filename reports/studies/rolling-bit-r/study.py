"""Speeds of the cones of bit R over twenty revolutions of cases/bit-r-rolling.toml."""

import json
import math

KEPT = ("commit", "compiler", "flags", "case_hash", "steps", "revolutions", "volume_ledger_defect", "rock_triangles_end", "rock_quality_min", "cones")


def speeds(run):
    """Means over every full revolution of the cones' speeds over the bit's."""
    angles, turned = run.history["cone_angle"].values, run.history["rotation_angle"].values
    names, first = [cone["name"] for cone in run.summary["cones"]], 0
    for revolution in range(1, int(run.summary["revolutions"]) + 1):
        last = next(i for i, angle in enumerate(turned) if angle >= 2.0 * math.pi * revolution - 1e-9)
        ratios = abs((angles[last] - angles[first]) / (turned[last] - turned[first]))
        yield {"revolution": revolution, **{name: f"{ratio:.6f}" for name, ratio in zip(names, ratios)}}
        first = last


def measure(m):
    run = m.run("cases/bit-r-rolling.toml", {"time.revolutions": 20})
    bit = json.loads((run.folder / "bit.json").read_text(encoding="utf-8"))
    m.write("cone_speeds.csv", speeds(run))
    m.write("rows.csv", ({"cone": cone["name"], "row": i, "rolling_ratio": row["rolling_ratio"]}
                         for cone in bit["cones"] for i, row in enumerate(cone["rows"], 1)))
    m.write_json("run.json", {k: run.summary[k] for k in KEPT} | {"intersecting_pairs": m.intersecting_pairs(run.folder / "rock_final.ply")})
