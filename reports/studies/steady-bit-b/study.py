"""Twenty revolutions of bit B at three edge lengths: volumes and meshes."""

import tomllib

KEPT = ("commit", "compiler", "flags", "case_hash", "steps", "gage_radius_m", "volume_ledger_defect", "rock_triangles_start",
        "rock_triangles_end", "rock_quality_min", "rock_quality_1_percent")


def measure(m):
    runs, volumes = {}, {}
    for edge in ("2 mm", "1.4 mm", "1 mm"):
        run = m.run("cases/bit-b-steady.toml", {"time.revolutions": 20, "rock.edge_length": edge})
        case = tomllib.loads((run.folder / "case.toml").read_text(encoding="utf-8"))
        runs[edge] = {k: run.summary[k] for k in KEPT} | {
            "intersecting_pairs": m.intersecting_pairs(run.folder / "rock_final.ply"), "motion": case["motion"]}
        volumes[f"m3 at {edge}"] = run.summary["removed_volume_by_revolution_m3"]
    m.write_json("runs.json", runs)
    m.write("volumes.csv", ({"revolution": i, **dict(zip(volumes, row))} for i, row in enumerate(zip(*volumes.values(), strict=True), 1)))
