"""measure.py TDBD TDBD_COMPARE FOLDER: bit B with sharp cutters over 100 m in two rocks, by TDBD and by Glowka's model. The cutters
at the end into cutters.csv; weight at a constant rate and rate at a constant weight over metres into metres.csv."""

import csv
import json
import subprocess
import sys
from math import cos, radians
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(ROOT / "reports"), str(HERE)]
from convergence import flat_case  # noqa: E402
from study_tools import write_rows  # noqa: E402

ROCKS = {"medium": (100e6, 60e6), "hard": (200e6, 120e6)}  # Pa: specific energy, stress under a flat
RATE = 15.0  # m/h
FRESH_WEIGHT, FRESH_TORQUE = {"medium": 16e3, "hard": 32e3}, {"medium": 1250, "hard": 2500}  # N, N m: about what that takes
METRES = range(0, 101, 10)


def settings(pairs):
    return [word for pair in pairs for word in ("--set", pair)]


def of_rock(rock, pairs=()):
    energy, stress = ROCKS[rock]
    return settings([f"forces.eps={energy}", f"forces.cutter_body.stress={stress}", "bit.set.mesh.rim_segments=256", *pairs])


def drilled(tdbd, case, rock, out, pairs=()):
    """`wear` of the summary."""
    subprocess.run([tdbd, "run", case, "-o", out, "--force", "--quiet", *of_rock(rock, pairs)], check=True)
    wear = json.loads((out / "summary.json").read_text())["wear"]
    assert wear["volume_ledger_defect"] <= 1e-12
    return wear


def cases(folder):
    """The case at a constant rate, and that at a constant weight."""
    text = (HERE / "tdbd.toml").read_text().replace("../../../cases/bits/bit-b.toml", "bit.toml")
    (folder / "rate.toml").write_text(text)
    before, rest = text.split("[motion]")
    after = rest[rest.index("[time]"):].replace("slip_speed = 0.0\n", "").replace("revolutions = 13", 'duration = "8 s"')
    weight = (HERE / "weight.toml").read_text()
    (folder / "weight.toml").write_text(before + weight[weight.index("[motion]"):] + "\n" + after.replace('step = "2 ms"', 'step = "1 ms"'))


def modelled(compare, folder, rock, metres):
    """Of Glowka's model after so many metres: {(cutter, quantity): value}; ("bit", "weight"): of the sharp bit."""
    energy, stress = ROCKS[rock]
    text = (HERE / "glowka.toml").read_text().replace("../../../cases/bits/bit-b.toml", str(folder / "bit.toml"))
    text = text.replace('eps = "100 MPa"', f"eps = {energy}").replace('flat_stress = "60 MPa"', f"flat_stress = {stress}")
    case, out = folder / "glowka.toml", folder / "glowka"
    case.write_text(text.replace('distance = "100 m"', f"distance = {max(metres, 1e-3)}"))
    subprocess.run([compare, case, "-o", out, "--force"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(out / "parts.csv", newline="") as file:
        found = {(r["part"], r["quantity"]): float(r["value"]) for r in csv.DictReader(file) if r["model"] == "glowka"}
    with open(out / "comparison.csv", newline="") as file:
        weights = [r["value"] for r in csv.DictReader(file) if (r["model"], r["quantity"]) == ("glowka", "weight")]
    return found | {("bit", "weight"): float(weights[0])}


def cutter_rows(rock, wear, glowka):
    for c in wear["cutters"]:
        yield {"rock": rock, "cutter": c["name"],
               "flat of TDBD, mm2": round(1e6 * c["flat_area_m2"], 3),
               "flat of Glowka's model, mm2": round(1e6 * glowka[c["name"], "wear_flat"], 3),
               "worn volume of TDBD, mm3": round(1e9 * c["worn_volume_m3"], 4),
               "temperature in TDBD, degC": round(c["temperature_k"] - 273.15, 1),
               "temperature in Glowka's model, degC": round(glowka[c["name"], "temperature"], 1)}


def metre_rows(rock, rate, weight, table, of_model):
    """The model: its flats bear as a whole, and what its sharp cutters bear is proportional to the rate."""
    stress, load = ROCKS[rock][1], FRESH_WEIGHT[rock]
    for distance, glowka in zip(METRES, of_model, strict=True):
        flats = sum(stress * glowka[f"cutter-{c['cutter']}", "wear_flat"] * cos(radians(float(c["profile_angle_deg"]))) for c in table)
        sharp = glowka["bit", "weight"]
        yield row(rock, "Glowka's model, constant rate", distance, sharp + flats, RATE)
        yield row(rock, "Glowka's model, constant weight", distance, load, RATE * (load - flats) / sharp)
    for drive, wear in (("rate", rate), ("weight", weight)):
        over = wear["over_distance"]
        for values in zip(over["distance_m"], over["weight_on_bit_n"], over["rate_of_penetration_m_per_s"], strict=True):
            yield row(rock, f"TDBD, constant {drive}", values[0], values[1], 3600 * values[2])


def row(rock, source, metres, weight, rate):
    return {"rock": rock, "source": source, "metres": round(metres, 2), "weight on bit, kN": round(weight / 1e3, 4),
            "rate of penetration, m/h": round(rate, 4)}


def main(tdbd, compare, folder):
    folder.mkdir(parents=True, exist_ok=True)
    table = flat_case(folder)
    cases(folder)
    cutters, metres = [], []
    for rock in ROCKS:
        rate = drilled(tdbd, folder / "rate.toml", rock, folder / f"rate-{rock}")
        weight = drilled(tdbd, folder / "weight.toml", rock, folder / f"weight-{rock}",
                         [f"motion.weight_on_bit={FRESH_WEIGHT[rock]}", f"motion.torque_at_start={FRESH_TORQUE[rock]}"])
        of_model = [modelled(compare, folder, rock, distance) for distance in METRES]
        cutters += cutter_rows(rock, rate, of_model[-1])
        metres += metre_rows(rock, rate, weight, table, of_model)
    write_rows(HERE / "cutters.csv", cutters)
    write_rows(HERE / "metres.csv", metres)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], Path(sys.argv[3]).resolve())
