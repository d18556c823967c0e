"""convergence.py TDBD FOLDER: the worn volume of cases/wear-bit-b.toml over edges, steps and wear steps, into convergence.csv."""

import json
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "reports"))
from study_tools import write_rows  # noqa: E402

SHIPPED = {"rock.edge_length": "3 mm", "time.step": "2 ms", "wear.largest_growth": "0.005", "wear.acceleration": "6000"}
THRESHOLD = {"thermal": "623.15", "sliding": "1e6"}  # K; a threshold that no flat reaches leaves the sliding law
TURNS = 8 * 6000  # of the case, times its acceleration
STUDIES = [("thermal", "rock.edge_length", ["3 mm", "2.1 mm", "1.5 mm", "1.05 mm"]),
           ("sliding", "rock.edge_length", ["3 mm"]),
           ("thermal", "time.step", ["4 ms", "2 ms", "1 ms", "0.5 ms"]),
           ("thermal", "wear.largest_growth", ["0.02", "0.01", "0.005", "0.0025", "0.00125"]),
           ("thermal", "wear.acceleration", ["24000", "12000", "6000", "3000"])]


def worn(tdbd, folder, law, changes):
    """mm3, of all cutters; the number of wear steps."""
    out = folder / "run"
    pairs = [f"{key}='{value}'" if " " in value else f"{key}={value}" for key, value in changes.items()]
    pairs += [f"wear.threshold={THRESHOLD[law]}", f"time.revolutions={TURNS / float(changes['wear.acceleration'])}"]
    settings = [word for pair in pairs for word in ("--set", pair)]
    subprocess.run([tdbd, "run", ROOT / "cases/wear-bit-b.toml", "-o", out, "--force", "--quiet", *settings], check=True,
                   stderr=subprocess.DEVNULL)
    wear = json.loads((out / "summary.json").read_text(encoding="utf-8"))["wear"]
    return 1e9 * sum(cutter["worn_volume_m3"] for cutter in wear["cutters"]), wear["wear_steps"]


def rows(tdbd, folder):
    for law, key, values in STUDIES:
        for value in values:
            volume, steps = worn(tdbd, folder, law, {**SHIPPED, key: value})
            yield {"law": law, "key": key, "value": value, "worn volume, mm3": round(volume, 2), "wear steps": steps}


if __name__ == "__main__":
    write_rows(HERE / "convergence.csv", list(rows(sys.argv[1], Path(sys.argv[2]))))
