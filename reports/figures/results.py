"""Reads result folders of `tdbd rotate` and `tdbd converge`. SI units."""

import json
from dataclasses import dataclass, field
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


def attitude_error(folder, reference):
    """||R - R_reference||_F / sqrt 2 at the end: the angle between them, rad, while it is small."""
    found, exact = (np.array(summary(f)["attitude"]) for f in (folder, reference))
    return float(np.linalg.norm(found - exact) / np.sqrt(2.0))
