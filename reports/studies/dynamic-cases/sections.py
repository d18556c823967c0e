#!/usr/bin/python3
"""Stick-slip with sections ahead of the faces and with sections extrapolated to them, over edge lengths.

    sections.py [--tdbd PROGRAM]

Runs cases/stick-slip.toml with both choices of measure.section_at_face and five edge lengths, with the step as shipped, and
writes sections.csv beside itself. Four minutes on one core.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "reports"))
from study_tools import write_rows  # noqa: E402

EDGES_MM = [2.8, 2, 1.4, 1, 0.7]


def figures(program, choice, edge_mm):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        subprocess.run([program, "run", ROOT / "cases/stick-slip.toml", "-o", out, "--quiet",
                        "--set", f'measure.section_at_face="{choice}"', "--set", f'rock.edge_length="{edge_mm} mm"'],
                       check=True, stderr=subprocess.DEVNULL)
        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    diagnosis = summary["diagnosis"]
    return {"section_at_face": choice, "edge_length_mm": edge_mm,
            "stick_slip_severity": diagnosis["stick_slip_severity"],
            "torsional_frequency_hz": diagnosis["torsional_frequency_hz"],
            "rop_mean_mm_per_s": 1e3 * summary["rop_mean_m_per_s"],
            "rotary_speed_mean_rad_per_s": summary["rotary_speed_mean_rad_per_s"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tdbd", default=str(ROOT / "build/release/tdbd"))
    program = parser.parse_args().tdbd
    write_rows(HERE / "sections.csv", [figures(program, choice, edge) for choice in ("as_ahead", "extrapolated") for edge in EDGES_MM])


if __name__ == "__main__":
    main()
