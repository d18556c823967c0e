#!/usr/bin/python3
"""measure.py [TDBD]: the order of the energy ledger's residual in the cases that drill, in windows at several moments. Writes orders.csv.

TDBD: the program, of a release build unless another is named. Half a minute.
"""

import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
CASES = ("drill-bit-b", "bit-bounce", "laboratory", "drill-bit-r", "drill-bit-b-whirl")
DURATIONS = (0.5, 0.6, 0.7, 0.8, 0.9, 1.0)  # s: the longer the run, the later its window


def order(program, case, duration):
    """None where the bit leaves the rock in the window."""
    settings = ("rock.edge_length='3 mm'", f"time.duration='{duration} s'", "output.energy_order=always")
    words = [word for setting in settings for word in ("--set", setting)]
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "run", ROOT / f"cases/{case}.toml", "-o", out, "--quiet", "--force", *words], check=True)
        return json.loads((Path(out) / "summary.json").read_text(encoding="utf-8"))["energy_residual_order"]


def main(program=ROOT / "build/release/tdbd"):
    with (HERE / "orders.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["case", "duration, s", "observed order"])
        for case in CASES:
            for duration in DURATIONS:
                found = order(program, case, duration)
                table.writerow([case, duration, "nan" if found is None else f"{found:.3f}"])


if __name__ == "__main__":
    main(*sys.argv[1:])
