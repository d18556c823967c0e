"""measure.py TDBD FOLDER [PART ...]: the CSV files of this study. PART: grooves, neighbours, bit, rows; all without one.

FOLDER holds the runs. The exact cross-sections of grooves come from grooves.py."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path[:0] = [str(HERE), str(ROOT / "validation"), str(HERE.parents[1])]
from grooves import RAKE, Rock  # noqa: E402
from study_tools import write_rows  # noqa: E402


def run(tdbd, case, out, settings):
    words = [word for s in settings for word in ("--set", s)]
    subprocess.run([tdbd, "run", case, "-o", out, "--force", "--quiet", *words], check=True, stderr=subprocess.DEVNULL)
    summary = json.loads((out / "summary.json").read_text())
    assert summary["volume_ledger_defect"] <= 1e-12
    return summary


def history(out):
    with (out / "history.csv").open(newline="") as file:
        head, *rows = csv.reader(file)
    columns = np.array(rows, dtype=float).T
    return {name.split(" ")[0]: columns[i] for i, name in enumerate(head)}


def measured_groove(out, start):
    """Area that leaves (slope of the volume over the way) and section across the path, m2; drag, N; in the middle of a groove."""
    h = history(out)
    inside = (h["time"] > start) & (h["position_y"] > -8e-3) & (h["position_y"] < 10e-3)
    area = np.polyfit(h["position_y"][inside], h["removed_volume_total"][inside], 1)[0]
    return area, h["section_area_total"][inside].mean() * np.cos(RAKE), -h["force_y"][inside].mean()


def spalling(angle, share=1.0, ahead=0.0):
    return [f"spalling={{angle='{angle} deg', depth_share={share}, ahead_share={ahead}}}"] if angle else []


def grooves(tdbd, folder):
    for angle, share, ahead in ((0, 0.0, 0.0), (60, 1.0, 0.0), (70, 1.0, 0.0), (70, 0.5, 0.0), (70, 1.0, 0.5)):
        cut, chipped, beside = Rock().groove(0.0, angle, share, ahead)
        for edge, step in ((2.0, 2.0), (1.4, 2.0), (1.0, 2.0), (0.7, 2.0), (0.5, 2.0), (1.0, 8.0), (1.0, 4.0), (1.0, 1.0), (1.0, 0.5)):
            settings = [f"rock.edge_length='{edge} mm'", f"time.step='{step} ms'", "time.duration=0.92"]
            run(tdbd, HERE / "groove.toml", folder / "groove", settings + spalling(angle, share, ahead))
            area, section, _ = measured_groove(folder / "groove", 0.2)
            exact = cut + chipped + beside
            yield {"angle, degrees": angle, "depth share": share, "ahead share": ahead, "edge, mm": edge, "step, ms": step,
                   "area that leaves, mm2": f"{1e6 * area:.4f}", "exact, mm2": f"{1e6 * exact:.4f}",
                   "error": f"{area / exact - 1.0:.1e}", "section, mm2": f"{1e6 * section:.4f}",
                   "its exact value, mm2": f"{1e6 * cut:.4f}", "its error": f"{section / cut - 1.0:.1e}"}


def neighbours(tdbd, folder):
    for spacing in (5.0, 7.0, 9.0, 11.0, 13.0, 17.0):
        for angle in (0, 60, 70):
            rock = Rock()
            rock.groove(0.0, angle, 1.0, 0.0)
            cut, _, beside = rock.groove(1e-3 * spacing, angle, 1.0, 0.0)
            settings = ["motion.legs=" + legs(1e-3 * spacing)]
            run(tdbd, HERE / "groove.toml", folder / "neighbour", settings + spalling(angle))
            area, section, drag = measured_groove(folder / "neighbour", 1.32)
            yield {"spacing, mm": spacing, "angle, degrees": angle, "section of the second groove, mm2": f"{1e6 * section:.3f}",
                   "exact, mm2": f"{1e6 * cut:.3f}", "its drag, N": f"{drag:.1f}", "area that leaves, mm2": f"{1e6 * area:.3f}",
                   "its exact value, mm2": f"{1e6 * (cut + beside):.3f}", "specific energy, MPa": f"{1e-6 * drag / area:.2f}"}


def legs(spacing):
    """The legs of groove.toml with another spacing."""
    ways = [(0.1, (0, -0.2, -0.05)), (0.1, (0, 0.02, 0.08)), (0.72, (0, 0.05, 0)), (0.1, (0, 0, -0.08)),
            (0.2, (spacing / 0.2, -0.19, 0)), (0.1, (0, 0.02, 0.08)), (0.72, (0, 0.05, 0))]
    return "[" + ", ".join(f"{{duration={t}, velocity=[{', '.join(f'{float(v)}' for v in way)}]}}" for t, way in ways) + "]"


def turning_bit(tdbd, folder):
    """Bit B at 5 mm a revolution, the third turn."""
    for angle, ahead in ((0, 0.0), (60, 0.0), (65, 0.0), (70, 0.0), (75, 0.0), (70, 0.3)):
        for edge in (2.0, 1.4, 1.0):
            settings = [f"rock.edge_length='{edge} mm'", "rock.pressure=0", "time.revolutions=3", "output.means_from='1 s'",
                        "motion.rotary_speed='120 rpm'", "motion.rate_of_penetration='36 m/h'"]
            s = run(tdbd, ROOT / "cases" / "bit-b-3000psi.toml", folder / "bit", settings + spalling(angle, 1.0, ahead))
            broken = sum(s.get("broken_out_volume_by_cutter_m3", {}).values())
            turn = s["removed_volume_by_revolution_m3"][2]
            yield {"angle, degrees": angle, "ahead share": ahead, "edge, mm": edge, "weight, N": f"{s['wob_mean_n']:.0f}",
                   "torque, N m": f"{s['tob_mean_n_m']:.1f}", "removed in the third turn, cm3": f"{1e6 * turn:.3f}",
                   "share broken out": f"{broken / s['removed_volume_m3']:.4f}"}


VARIANTS = {"none": [], "beside, 60 degrees": ["--set", "spalling.angle=60 deg"], "beside, 75 degrees": ["--set", "spalling.angle=75 deg"],
            "beside, 60 degrees, half ahead": ["--set", "spalling.angle=60 deg", "--set", "spalling.ahead_share=0.5"]}


def rows(tdbd, folder):
    """The atmospheric comparisons of validation/."""
    import compare
    import comparison
    import validate
    split = [c for c in comparison.read_split() if c["kind"] == "measured"]
    for variant, options in VARIANTS.items():
        results = folder / ("rows-" + "-".join(variant.replace(",", "").split()))
        results.mkdir(parents=True, exist_ok=True)
        for case, before in validate.runs(split):
            validate.calibrate(tdbd, case, results, before, options)
        for c in compare.compare(results, split):
            for load in c.loads:
                yield {"comparison": c.name, "law": c.law, "load": load.name, "break-out": variant, "mean error": f"{load.mean():.4f}",
                       "rms error": f"{load.rms():.4f}", "verdict": c.verdict()}


PARTS = {"grooves": grooves, "neighbours": neighbours, "bit": turning_bit, "rows": rows}

if __name__ == "__main__":
    program, place = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    place.mkdir(parents=True, exist_ok=True)
    for part in sys.argv[3:] or PARTS:
        write_rows(HERE / f"{part}.csv", list(PARTS[part](program, place)))
