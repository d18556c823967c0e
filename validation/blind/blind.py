"""The blind test: predicts bits that are drilled with laws unknown to the calibration, and evaluates the predictions.

All predictions are written before any true load exists. The laboratory first drills the fitted bits
only. The records of the withheld bit enter the calibration with rates of penetration but without
readings. The laboratory drills the withheld bits after the last prediction is written.
"""

import csv
import shutil
from dataclasses import dataclass
from pathlib import Path

import lab_runs
import numpy as np
from lab_runs import PAIRINGS

HERE = Path(__file__).resolve().parent
LAWS = ("hanson-hansen", "size-effect", "thin-cut", "detournay")
LOADS = ("wob", "tob")
DRAWS = 2
EXACT = ("noise.reading=1e-12", "noise.test=0", "noise.rop=0")


def case_of(law):
    return HERE / f"hidden-{law}.toml"


@dataclass(frozen=True)
class Job:
    law: str
    pairing: object
    draw: int
    folder: Path

    def records(self):
        return self.folder / "records.csv"

    def predictions(self):
        return self.folder / "result/predictions.csv"


def bits(names):
    return f"laboratory.bits=[{', '.join(f'{chr(34)}{n}{chr(34)}' for n in names)}]"


def seeds(draw, pairing_index, is_truth):
    """Seeds of the laboratory. No two calls share one."""
    return f"laboratory.seed={1000 * (draw + 1) + 10 * pairing_index + int(is_truth)}"


def add_withheld(path, bit, fitted_bit):
    """The tests of the withheld bit: those of a fitted bit under its name, without readings."""
    with path.open(newline="", encoding="utf-8") as file:
        heading, *rows = csv.reader(file)
    place = {name.split(" [")[0]: i for i, name in enumerate(heading)}
    for row in [r for r in rows if r[place["bit"]] == fitted_bit]:
        asked = list(row)
        asked[place["bit"]] = bit
        asked[place["test"]] = bit + row[place["test"]].removeprefix(fitted_bit)
        for load in LOADS:
            asked[place[load]] = ""
        rows.append(asked)
    with path.open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([heading, *rows])


def predict(program, job):
    """Fits and predicts. Leaves only the input and the results of the calibration."""
    p = job.pairing
    shutil.rmtree(job.folder, ignore_errors=True)
    job.folder.mkdir(parents=True)
    program.laboratory(case_of(job.law), job.records(),
                       (bits(p.fitted), seeds(job.draw, PAIRINGS.index(p), is_truth=False)))
    add_withheld(job.records(), p.withheld, p.fitted[0])
    program.calibrate(lab_runs.CASES / f"lab-{p.name}.toml", job.folder / "result",
                      (f"calibration.records={job.records()}", "noise.rop=0"))
    for cuts in (job.folder / "result").glob("cuts-*.nc"):  # copies of cut runs
        cuts.unlink()


def truths(program, out, draws):
    """{(law, bit, draw or None)}: rows without noise (None) or with that of a draw. Called after all predictions."""
    calls = [(law, p, draw) for law in LAWS for p in PAIRINGS for draw in (None, *range(draws))]

    def drill(call):
        law, p, draw = call
        path = Path(out) / "truth" / f"{law}-{p.withheld}-{'exact' if draw is None else draw}.csv"
        noise = EXACT if draw is None else (seeds(draw, PAIRINGS.index(p), is_truth=True),)
        program.laboratory(case_of(law), path, (bits([p.withheld]), *noise))
        return lab_runs.read_rows(path)
    return dict(zip(((law, p.withheld, d) for law, p, d in calls), program.each(drill, calls), strict=True))


def matched(predictions, rows):
    """Pairs each prediction with the row of the same test."""
    by_place = {(r["test"], r["rate_of_penetration"]): r for r in rows}
    return [(p, by_place[p["test"], p["rate_of_penetration"]]) for p in predictions]


def judged(law, pairing, jobs, truth):
    """One row of the table: errors relative to loads without noise, coverage of readings with noise."""
    errors, covered, extrapolates = {k: [] for k in LOADS}, [], 0
    for job in jobs:
        predictions = lab_runs.read_rows(job.predictions())
        extrapolates += lab_runs.read_json(job.folder / "result/calibration.json")["extrapolates"]
        for load in LOADS:
            for p, exact in matched(predictions, truth[law, pairing.withheld, None]):
                errors[load].append(p[f"{load}_mean"] / exact[load] - 1.0)
            for p, read in matched(predictions, truth[law, pairing.withheld, job.draw]):
                covered.append(p[f"{load}_low"] <= read[load] <= p[f"{load}_high"])
    both = np.abs(np.concatenate([errors[k] for k in LOADS]))
    return {"hidden law": law, "pairing": pairing.words(), "draws": len(jobs),
            "wob_rms": float(np.sqrt(np.mean(np.square(errors["wob"])))),
            "tob_rms": float(np.sqrt(np.mean(np.square(errors["tob"])))),
            "p95": float(np.quantile(both, 0.95)), "coverage": float(np.mean(covered)),
            "extrapolates": extrapolates / len(jobs)}


def run(program, out, draws=DRAWS):
    """Returns the rows of the table: hidden law x pairing."""
    out = Path(out)
    shutil.rmtree(out, ignore_errors=True)
    jobs = [Job(law, p, draw, out / f"{law}-{p.name}-{draw}") for law in LAWS for p in PAIRINGS for draw in range(draws)]
    program.each(lambda job: predict(program, job), jobs)
    truth = truths(program, out, draws)  # computed last, so that no prediction can use it
    return [judged(law, p, [j for j in jobs if (j.law, j.pairing) == (law, p)], truth) for law in LAWS for p in PAIRINGS]
