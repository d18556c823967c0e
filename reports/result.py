"""Reads a TDBD result folder: the rock's surface, the summary, the bit's cutters. SI units."""

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from figures import rock_data


@dataclass
class Cutter:
    """One cutter of bit.json with what its parts removed."""

    name: str
    tip_radius: float  # m
    blade: int
    zone: str
    volumes: np.ndarray = field(default_factory=lambda: np.zeros(0))  # m3 per revolution


def read_surface(path):
    """The rock's surface in a .vtp file, with depth_m: z where the file has none."""
    try:
        surface = rock_data.read(path)
    except ValueError as error:
        raise SystemExit(str(error)) from error
    surface.point_values.setdefault("depth_m", surface.points[:, 2])
    return surface


def read_json(path):
    if not path.is_file():
        raise SystemExit(f"{path}: no such file")
    return json.loads(path.read_text())


def full_revolutions(summary):
    """Revolutions that were drilled to their end."""
    return int(np.floor(summary["revolutions"] + 1e-9))


def read_cutters(folder, summary):
    """The cutters of bit.json, by tip radius, each with the volumes of all its parts added."""
    volumes = summary["removed_volume_by_part_by_revolution_m3"]
    cutters = []
    for row in read_json(Path(folder) / "bit.json")["cutters"]:
        own = [v for part, v in volumes.items() if part.split("/")[0] == row["name"]]
        total = np.sum(own, axis=0) if own else np.zeros(0)
        cutters.append(
            Cutter(row["name"], row["tip_radius_m"], row.get("blade", 0), row.get("zone", ""), total)
        )
    return sorted(cutters, key=lambda c: c.tip_radius)
