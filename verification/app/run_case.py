"""run_case.py TDBD CASE.toml FOLDER: the first moments of a case, all defaults of its own.

The command line is `tdbd run CASE` or, when it has a table [body], `tdbd rotate CASE`, or, when its string has sections and no bit, `tdbd string CASE`, cut short; it
has to end well. What was drilled without forces is drawn.
"""

import json
import math
import pathlib
import subprocess
import sys
import tomllib

tdbd, case, folder = sys.argv[1:]
with open(case, "rb") as file:
    content = tomllib.load(file)


def summary_of(command, key, value, more=()):
    subprocess.run([tdbd, command, case, "-o", folder, "--force", "--quiet",
                    "--set", f"time.{key}={value}", *more], check=True)
    with open(folder + "/summary.json", encoding="utf-8") as summary_file:
        summary = json.load(summary_file)
    assert summary["status"] == "completed", summary["status"]
    assert summary["steps"] > 0
    return summary


def rotate():
    """Ten steps: what is conserved is conserved."""
    step = content["time"]["step"]
    summary = summary_of("rotate", "duration", "0.1 s" if isinstance(step, str) else 10 * step)
    assert summary["unit_quaternion_defect_max"] <= 1e-15, summary
    load = content.get("load", {})
    if not load:
        assert summary["momentum_drift_max"] == 0.0, summary
    if set(load) <= {"gravity_moment", "gravity_arm"}:
        assert summary["vertical_momentum_drift_max"] == 0.0, summary
        assert summary["energy_drift_max"] < 1e-3, summary
    assert all(math.isfinite(x) for row in summary["attitude"] for x in row)


def asked_for_forces(summary):
    """Numbers, and energy accounted for; what such a run drills is drawn of cases without forces."""
    for name in ("wob_mean_n", "tob_mean_n_m", "rop_mean_m_per_s"):
        assert math.isfinite(summary[name]), name
    if content["motion"]["kind"] == "drilling":
        energy = summary["energy"]
        assert abs(energy["residual_j"]) <= 1e-2 * energy["start_j"], energy


def drill():
    key = "revolutions" if "revolutions" in content.get("time", {}) else "duration"
    means = ("--set", "output.means_from='0 s'") if "forces" in content else ()
    summary = summary_of("run", key, "0.02" if key == "revolutions" else "10 ms", means)
    assert summary["volume_ledger_defect"] <= 1e-12, summary["volume_ledger_defect"]
    if "forces" in content:
        return asked_for_forces(summary)
    draw = pathlib.Path(__file__).resolve().parents[2] / "reports" / "draw.py"
    subprocess.run([sys.executable, "-B", draw, folder], check=True, stdout=subprocess.DEVNULL)
    has_cutters = json.loads((pathlib.Path(folder) / "bit.json").read_text())["cutters"]
    for figure in ("bottom_hole.png", "side_view.png", *(["cutters.png"] if has_cutters else [])):
        assert (pathlib.Path(folder) / figure).stat().st_size > 10_000, figure


def string():
    """A tenth of a second: statics, frequencies, energy accounted for; drawn."""
    summary = summary_of("string", "duration", "0.1 s")
    assert summary["static"]["pull_up"]["hook_load_n"] >= summary["static"]["rotate"]["hook_load_n"]
    assert len(summary["torsional_frequencies_hz"]) == 3
    assert summary["energy"]["residual_max_j"] <= 1.0, summary["energy"]
    draw = pathlib.Path(__file__).resolve().parents[2] / "reports" / "draw.py"
    subprocess.run([sys.executable, "-B", draw, folder], check=True, stdout=subprocess.DEVNULL)
    for figure in ("torque_and_drag", "broomstick", "modes", "traces", "time_depth"):
        assert (pathlib.Path(folder) / f"{figure}.png").stat().st_size > 10_000, figure


if "body" in content:
    rotate()
elif "sections" in content.get("string", {}) and "bit" not in content:
    string()
else:
    drill()
