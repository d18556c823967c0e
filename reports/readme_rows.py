"""The rows of the table of measurements in docs/evidence/accuracy.md: the numbers, and where each is read from."""

import csv
import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from fingerprint import Stale


@dataclass(frozen=True)
class Measured:
    """The largest measurement of a claim, of those whose text contains `part`."""
    claim: str
    part: str
    scale: float = 1.0

    def key(self):
        return f"{self.claim}: {self.part}"

    def read(self, evidence):
        """Raises Stale if no test recorded it."""
        found = [e for e in evidence.get(self.claim, []) if self.part in e.what]
        if not found:
            raise Stale(f"docs/evidence/accuracy.md: no evidence for {self.key()}; run ctest -L evidence")
        return self.scale * max(e.measured for e in found)


@dataclass(frozen=True)
class Kept:
    """A number that is computed from the data of a study."""
    folder: str
    name: str
    of: Callable

    def key(self):
        return f"{self.folder}: {self.name}"

    def read(self, root):
        return self.of(Path(root) / self.folder)


@dataclass(frozen=True)
class Row:
    what: str
    value: str  # with a placeholder for each number
    numbers: tuple
    by: str


def run_of(file, *path):
    def read(folder):
        found = json.loads((folder / file).read_text(encoding="utf-8"))
        for name in path:
            found = found[name]
        return found
    return read


def largest_excess(folder):
    """Largest difference between the volume of a revolution and pi R^2 d, from the second revolution on, with edges of 1 mm, in per cent."""
    run = run_of("runs.json", "1 mm")(folder)
    advance = run["motion"]["rate_of_penetration"] * 2.0 * math.pi / run["motion"]["rotary_speed"]
    whole = math.pi * run["gage_radius_m"] ** 2 * advance
    with (folder / "volumes.csv").open(newline="", encoding="utf-8") as file:
        volumes = [float(row["m3 at 1 mm"]) for row in csv.DictReader(file)]
    return 100.0 * max(abs(v / whole - 1.0) for v in volumes[1:])


def worst_ledger(folder):
    return max(run["volume_ledger_defect"] for run in json.loads((folder / "runs.json").read_text(encoding="utf-8")).values())


STEADY, ROLLING = "reports/studies/steady-bit-b", "reports/studies/rolling-bit-r"

ROWS = [
    Row("volume removed in a revolution, compared with pi R^2 d: revolutions 2 to 20, edges of 1 mm", "within {:.2f} %",
        (Kept(STEADY, "largest excess", largest_excess),), f"study `{STEADY}`"),
    Row("relative error of the volume balance after 20 revolutions, largest of three meshes", "{:.0e}",
        (Kept(STEADY, "ledger", worst_ledger),), f"study `{STEADY}`"),
    Row("pairs of intersecting triangles after 20 revolutions, edges of 1 mm, found by CGAL", "{:.0f} among {:.0f} triangles",
        (Kept(STEADY, "intersecting pairs", run_of("runs.json", "1 mm", "intersecting_pairs")),
         Kept(STEADY, "triangles", run_of("runs.json", "1 mm", "rock_triangles_end"))), f"study `{STEADY}`"),
    Row("roller cone bit, 20 revolutions: relative error of the volume balance", "{:.0e}",
        (Kept(ROLLING, "volume_ledger_defect", run_of("run.json", "volume_ledger_defect")),), f"study `{ROLLING}`"),
    Row("roller cone bit, 20 revolutions: quality of the worst triangle (1: equilateral)", "{:.2f}",
        (Kept(ROLLING, "rock_quality_min", run_of("run.json", "rock_quality_min")),), f"study `{ROLLING}`"),
    Row("roller cone bit, 20 revolutions: pairs of intersecting triangles", "{:.0f} among {:.0f} triangles",
        tuple(Kept(ROLLING, name, run_of("run.json", name)) for name in ("intersecting_pairs", "rock_triangles_end")),
        f"study `{ROLLING}`"),
    Row("power of a sharp bit, w T + v W, compared with eps pi R^2 v, edges of 1 mm", "within {:.1f} %",
        (Measured("literature/detournay-power", "edges of 1 mm", 100.0),), "test `Forces.of_a_sharp_bit_have_the_power_of_its_volume`"),
    Row("change of the momentum of a free body with cones over 1e7 time steps", "{:.0f}",
        (Measured("ours/momentum", "split: change of the spatial momentum"),),
        "test `Conservation.momentum_of_a_free_gyrostat_is_bitwise_constant_over_1e7_steps`"),
    Row("error of the symplectic condition in a time step of the default integrator", "{:.0e}", (Measured("ours/symplectic", "split: largest"),),
        "test `Symplecticity.every_drift_but_the_thesis_one_is_symplectic_to_rounding`"),
    Row("torque evaluations that order 8 needs to integrate the slow top with an error of 1e-9 rad", "{:.0f}",
        (Measured("ours/fewer-evaluations", "order 8 of the split"),),
        "test `Work.the_eighth_order_reaches_a_billionth_in_1100_evaluations`"),
    Row("error of the predicted loads of bit A, from a fit to bits B and C (synthetic laboratory, 95th percentile of 25 draws)", "{:.1f} %",
        (Measured("chapter6/prediction", "A is predicted: error of its loads", 100.0),),
        "test `BlindLaboratory.predicts_the_withheld_bit_under_a_known_law`"),
    Row("torque of the drag-bit models on one bit, third revolution, compared with eps R^2 d/2", "within {:.2f} %",
        (Measured("chapter2/models-agree", "eps R^2 d / 2, distance from 1", 100.0),), "test `ModelsAgree.on_areas_and_torque_of_a_steady_bit`"),
    Row("cut areas of TDBD, compared with the planar model, for cutters that cut 2 mm2 or more, without the innermost cutter", "within {:.1f} %",
        (Measured("chapter2/models-agree", "TDBD: areas over those of the turned plane, largest distance from 1, cutters beyond r = 5 mm that cut",
                  100.0),), "test `ModelsAgree.on_areas_and_torque_of_a_steady_bit`"),
    Row("lobes found in the bottom pattern of a whirling bit with 73 lobes, by planes every 0.5 degrees and every 5 degrees", "{:.0f} and {:.0f}",
        (Measured("chapter2/whirl-aliases", "1.5 mm all round, 720 planes"), Measured("chapter2/whirl-aliases", "1.5 mm all round, 72 planes")),
        "test `WhirlPattern.of_73_lobes_is_one_lobe_on_72_planes`"),
]
