"""measure.py TDBD TDBD_COMPARE FOLDER: bit B after 100 m in two rocks, by TDBD and by Glowka's model, into cutters.csv."""

import csv
import json
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROCKS = {"medium": ("100 MPa", "60 MPa"), "hard": ("200 MPa", "120 MPa")}  # specific energy, stress under a flat


def settings(pairs):
    return [word for pair in pairs for word in ("--set", pair)]


def drilled(tdbd, folder, rock):
    """TDBD's cutters at the end of the run."""
    energy, stress = ROCKS[rock]
    out = folder / f"tdbd-{rock}"
    pairs = [f"forces.eps='{energy}'", f"forces.chamfer.stress='{stress}'", f"forces.cutter_body.stress='{stress}'"]
    subprocess.run([tdbd, "run", HERE / "tdbd.toml", "-o", out, *settings(pairs)], check=True, stdout=subprocess.DEVNULL)
    wear = json.loads((out / "summary.json").read_text())["wear"]
    assert wear["volume_ledger_defect"] <= 1e-12
    return wear["cutters"]


def modelled(compare, folder, rock):
    """Flat area (m2) and temperature (degC) of Glowka's cutters, by name and quantity."""
    energy, stress = ROCKS[rock]
    text = (HERE / "glowka.toml").read_text().replace("../../../cases", str(HERE.parents[2] / "cases"))
    text = text.replace('eps = "100 MPa"', f'eps = "{energy}"').replace('flat_stress = "60 MPa"', f'flat_stress = "{stress}"')
    case, out = folder / f"glowka-{rock}.toml", folder / f"glowka-{rock}"
    case.write_text(text)
    subprocess.run([compare, case, "-o", out], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(out / "parts.csv", newline="") as file:
        return {(r["part"], r["quantity"]): float(r["value"]) for r in csv.DictReader(file) if r["model"] == "glowka"}


def rows(tdbd, compare, folder):
    for rock in ROCKS:
        glowka = modelled(compare, folder, rock)
        for c in drilled(tdbd, folder, rock):
            yield {"rock": rock, "cutter": c["name"],
                   "flat of TDBD, mm2": round(1e6 * c["flat_area_m2"], 3),
                   "flat of Glowka's model, mm2": round(1e6 * glowka[c["name"], "wear_flat"], 3),
                   "worn volume of TDBD, mm3": round(1e9 * c["worn_volume_m3"], 4),
                   "temperature in TDBD, degC": round(c["temperature_k"] - 273.15, 1),
                   "temperature in Glowka's model, degC": round(glowka[c["name"], "temperature"], 1)}


if __name__ == "__main__":
    folder = Path(sys.argv[3]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    table = list(rows(sys.argv[1], sys.argv[2], folder))
    with open(HERE / "cutters.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, table[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(table)
