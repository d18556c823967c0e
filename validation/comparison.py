"""One comparison of validation/split.toml: the predictions of a calibration and the measured values."""

import csv
import json
import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
KINDS = ("measured", "published model", "synthetic laboratory")
VERDICTS = ("within the floor", "within 2 floors", "fails")
LOADS = (("wob", "N"), ("tob", "N m"), ("normal", "N"), ("drag", "N"))


class Problem(Exception):
    """A mistake in the input, described for the user."""


@dataclass
class Floor:
    """The smallest error of a load that can be expected, relative."""
    mean: float
    rms: float


@dataclass
class Load:
    """One load of the predicted records: predicted and measured values (SI), and the floor of its error."""
    name: str
    unit: str
    predicted: list
    measured: list
    inside: list   # whether the measured value is inside the predicted interval
    floor: "Floor"

    def errors(self):
        return [p / m - 1.0 for p, m in zip(self.predicted, self.measured)]

    def mean(self):
        return sum(self.errors()) / len(self.predicted)

    def rms(self):
        return math.sqrt(sum(e * e for e in self.errors()) / len(self.predicted))

    def in_floors(self):
        """Mean or rms error relative to its floor, whichever is larger."""
        return max(abs(self.mean()) / self.floor.mean, self.rms() / self.floor.rms)


@dataclass
class Compared:
    """One comparison with one law."""
    name: str
    title: str
    kind: str
    law: str
    loads: list
    extrapolates: bool
    floor_of: str
    expected: str
    why: str

    def readings(self):
        return sum(len(load.predicted) for load in self.loads)

    def inside(self):
        return sum(sum(load.inside) for load in self.loads) / self.readings()

    def in_floors(self):
        return max(load.in_floors() for load in self.loads)

    def verdict(self):
        worst = self.in_floors()
        return VERDICTS[0] if worst <= 1.0 else VERDICTS[1] if worst <= 2.0 else VERDICTS[2]


def read_split(path=HERE / "split.toml"):
    """Returns the tables [[comparison]] of the split."""
    return tomllib.loads(Path(path).read_text(encoding="utf-8"))["comparison"]


def floors(path=HERE / "records" / "floors.csv"):
    """Returns {(floor, load): Floor}."""
    with Path(path).open(newline="", encoding="utf-8") as file:
        return {(r["floor"], r["load"]): Floor(float(r["mean"]), float(r["rms"])) for r in csv.DictReader(file)}


def floor_of(comparison, load, known):
    """The floor of a load: a number in the split, or the largest of the named floors."""
    given = comparison["floor"]
    if not isinstance(given, list):
        return Floor(float(given), float(given))
    found = [known[name, load] for name in given if (name, load) in known]
    if not found:
        raise Problem(f"split.toml: comparison {comparison['name']}: floor: found {given} without {load}, "
                      "expected names of records/floors.csv or a number")
    return Floor(max(f.mean for f in found), max(f.rms for f in found))


def read_load(rows, name, unit, floor):
    """A load of predictions.csv at the records where it was measured; None if it never was."""
    cells = [[r.get(f"{column} [{unit}]") or "" for column in (f"measured_{name}", f"{name}_mean", f"{name}_low", f"{name}_high")]
             for r in rows]
    kept = [[float(c) for c in four] for four in cells if four[0]]
    if not kept:
        return None
    return Load(name, unit, [c[1] for c in kept], [c[0] for c in kept], [c[2] <= c[0] <= c[3] for c in kept], floor)


def read_compared(comparison, law, verdict, results, known):
    """Reads a comparison with one law from its result folder."""
    folder = Path(results) / verdict["case"]
    try:
        summary = json.loads((folder / "calibration.json").read_text(encoding="utf-8"))
        with (folder / "predictions.csv").open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise Problem(f"{folder}: found no result ({error.strerror}), expected one of tdbd calibrate") from error
    loads = []
    for name, unit in LOADS:
        measured = any(r.get(f"measured_{name} [{unit}]") for r in rows)
        if measured:
            loads.append(read_load(rows, name, unit, floor_of(comparison, name, known)))
    if not loads:
        raise Problem(f"{folder / 'predictions.csv'}: found no measured load, expected one")
    return Compared(comparison["name"], comparison["title"], comparison["kind"], law, loads,
                    bool(summary.get("extrapolates")), comparison["floor_of"], verdict["verdict"], verdict["why"])


def read_all(split, results, known):
    return [read_compared(c, law, verdict, results, known)
            for c in split for law, verdict in c["law"].items()]
