"""convergence.py TDBD FOLDER [flats | cases | wear-steps]: the worn volume of cases/wear-bit-b.toml over edges, steps and wear steps,
into convergence.csv; that of its flats alone beside the half-planes, into flats.csv; and over the time steps between two wear steps,
into wear_steps.csv."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "reports"), str(HERE)]
from half_planes import worn_volumes  # noqa: E402
from study_tools import write_rows  # noqa: E402

SHIPPED = {"rock.edge_length": "3 mm", "time.step": "2 ms", "wear.largest_growth": "0.005", "wear.acceleration": "6000",
           "wear.from": "0 s"}
TURNS = 8 * 6000  # times the acceleration
STUDIES = [("rock.edge_length", ["3 mm", "2.1 mm", "1.5 mm", "1.05 mm"]),
           ("time.step", ["1 ms", "0.5 ms"]),
           ("wear.largest_growth", ["0.02"]),
           ("wear.acceleration", ["12000", "3000"])]
EDGES, SEGMENTS = ["3 mm", "2.1 mm", "1.5 mm", "1.05 mm", "0.75 mm"], ["64", "128", "256"]
WEAR_STEPS = ["512", "256", "128", "64", "32", "8"]  # time steps between two wear steps; the last is the limit of the others
START_FLAT, STRESS, GAGE = "0.100", 100e6, 23  # mm; Pa; the cutters before these are not at the gage


def run(tdbd, case, out, changes):
    """`wear` of the summary."""
    pairs = [f"{key}='{value}'" if " " in value else f"{key}={value}" for key, value in changes.items()]
    settings = [word for pair in pairs for word in ("--set", pair)]
    subprocess.run([tdbd, "run", case, "-o", out, "--force", "--quiet", *settings], check=True, stderr=subprocess.DEVNULL)
    return json.loads((out / "summary.json").read_text(encoding="utf-8"))["wear"]


def volume(wear, cutters=None):
    """mm3, of the first cutters, or all."""
    return 1e9 * sum(cutter["worn_volume_m3"] for cutter in wear["cutters"][:cutters])


def convergence(tdbd, folder):
    for key, values in STUDIES:
        for value in values:
            changes = {**SHIPPED, key: value}
            changes["time.revolutions"] = str(TURNS / float(changes["wear.acceleration"]))
            wear = run(tdbd, ROOT / "cases/wear-bit-b.toml", folder / "run", changes)
            yield {"key": key, "value": value, "worn volume, mm3": round(volume(wear), 3), "wear steps": wear["wear_steps"]}


def wear_steps(tdbd, folder):
    """Ten turns after two that do not wear, so that the cuts are steady: what begins with the wear is smooth."""
    found = []
    for every in WEAR_STEPS:
        changes = {**SHIPPED, "wear.from": "1 s", "wear.every_steps": every, "wear.largest_growth": "0.1", "time.revolutions": "12"}
        wear = run(tdbd, ROOT / "cases/wear-bit-b.toml", folder / "order", changes)
        found.append((int(every), wear["wear_steps"], 1e9 * np.array([c["worn_volume_m3"] for c in wear["cutters"]])))
    limit = found[-1][2]
    for every, count, volumes in found:
        yield {"time steps between wear steps": every, "wear steps": count, "worn volume, mm3": round(volumes.sum(), 3),
               "difference of the cutters' volumes from the last row, mm3, root of the sum of squares": round(np.linalg.norm(volumes - limit), 4)}


def flat_case(folder):
    """The case with sharp cutters that begin with a flat and wear there alone; the rows of its cutter table."""
    bits = ROOT / "cases/bits"
    with open(bits / "bit-b.csv", newline="", encoding="utf-8") as file:
        rows = [{**row, "wear_mm": START_FLAT} for row in csv.DictReader(file)]
    write_rows(folder / "bit.csv", rows)
    text = (bits / "bit-b.toml").read_text(encoding="utf-8")
    (folder / "bit.toml").write_text(text.replace("bit-b.csv", "bit.csv").replace('chamfer = "0.3 mm"', 'chamfer = "0 mm"'))
    text = (ROOT / "cases/wear-bit-b.toml").read_text(encoding="utf-8").replace("bits/bit-b.toml", "bit.toml")
    (folder / "flats.toml").write_text(text + '\n[wear.areas.faces]\nkind = "face"\nlaw = "none"\n')
    return rows


def flats(tdbd, folder):
    rows = flat_case(folder)
    steady = {"advance": 15 / 3600 / 2, "speed": 4 * np.pi, "turns": 9, "first": 1, "rate": 6000 * 1e-5 / 50e9, "stress": STRESS}
    limit = 1e9 * sum(worn_volumes(rows, steady)[:GAGE])
    for edge, segments in [(e, "256") for e in EDGES] + [("1.5 mm", s) for s in SEGMENTS[:-1]]:
        changes = {"rock.edge_length": edge, "bit.set.mesh.rim_segments": segments, "wear.largest_growth": "0.0025"}
        wear = run(tdbd, folder / "flats.toml", folder / "run", changes)
        yield {"edge": edge, "rim segments": int(segments), "worn volume, mm3": round(volume(wear, GAGE), 3),
               "in half-planes, mm3": round(limit, 3)}


if __name__ == "__main__":
    where = Path(sys.argv[2]).resolve()
    where.mkdir(parents=True, exist_ok=True)
    parts = {"flats": ("flats.csv", flats), "cases": ("convergence.csv", convergence), "wear-steps": ("wear_steps.csv", wear_steps)}
    for part in sys.argv[3:] or parts:
        name, rows = parts[part]
        write_rows(HERE / name, list(rows(sys.argv[1], where)))
