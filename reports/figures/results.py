"""Reads result folders of `tdbd rotate` and `tdbd converge`. SI units."""

import json
from dataclasses import dataclass
from pathlib import Path

import netCDF4
import numpy as np


def history(folder, *names):
    """Variables of history.nc, as arrays (time first)."""
    with netCDF4.Dataset(Path(folder) / "history.nc") as data:
        return [np.asarray(data[name][:]) for name in names]


def read_json(folder, name):
    return json.loads((Path(folder) / name).read_text(encoding="utf-8"))


def summary(folder):
    return read_json(folder, "summary.json")


def printed_lines(folder):
    """What a twin printed: one JSON object a line."""
    return [json.loads(line) for line in (Path(folder) / "stdout.txt").read_text(encoding="utf-8").splitlines()]


def attitude_error(folder, reference):
    """||R - R_reference||_F / sqrt 2 at the end: the angle between them, rad, while it is small."""
    found, exact = (np.array(summary(f)["attitude"]) for f in (folder, reference))
    return float(np.linalg.norm(found - exact) / np.sqrt(2.0))


@dataclass(frozen=True)
class Study:
    """How one state variable converges."""

    sizes: np.ndarray  # s
    errors: np.ndarray  # in the variable's unit
    words: str  # the observed order, or why there is none


NO_ORDER = {"too few": "not known (too few points above rounding)", "exact": "not needed (the results are exact)",
            "not settled": "not known (local orders have not settled)"}


def in_words(variable, digits=2):
    """The order as a number, or why there is none."""
    order = variable["order"]
    return NO_ORDER.get(variable["verdict"], variable["verdict"]) if order is None else f"{order:.{digits}f}"


def convergence(folder):
    """{variable: Study} of convergence.json: differences to the next level."""
    document = read_json(folder, "convergence.json")
    sizes = np.array([level["size"] for level in document["levels"]])
    studies = {}
    for name, v in document["variables"].items():
        errors = np.array(v["differences"], dtype=float)
        studies[name] = Study(sizes[:len(errors)], errors, in_words(v))
    return studies
