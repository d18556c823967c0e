"""run_case.py TDBD CASE.toml FOLDER: the first moments of a case, all defaults of its own, drawn.

The command line is `tdbd run CASE`, cut short to ten steps; the run has to end well.
"""

import json
import pathlib
import subprocess
import sys
import tomllib

tdbd, case, folder = sys.argv[1:]
with open(case, "rb") as file:
    time = tomllib.load(file).get("time", {})
key = "revolutions" if "revolutions" in time else "duration"
short = "0.02" if key == "revolutions" else "10 ms"
subprocess.run([tdbd, "run", case, "-o", folder, "--force", "--quiet", "--set", f"time.{key}={short}"],
               check=True)
with open(folder + "/summary.json", encoding="utf-8") as file:
    summary = json.load(file)
assert summary["status"] == "completed", summary["status"]
assert summary["steps"] > 0
assert summary["volume_ledger_defect"] <= 1e-12, summary["volume_ledger_defect"]

draw = pathlib.Path(__file__).resolve().parents[2] / "reports" / "draw.py"
subprocess.run([sys.executable, "-B", draw, folder], check=True, stdout=subprocess.DEVNULL)
for figure in ("bottom_hole.png", "side_view.png", "cutters.png"):
    assert (pathlib.Path(folder) / figure).stat().st_size > 10_000, figure
