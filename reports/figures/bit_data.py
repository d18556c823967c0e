"""Reads what `tdbd bit BIT -o FOLDER --report` writes. SI units, the bit's frame: z down."""

import csv
import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from figures import rock_data
from figures.render import smooth_normals


class BadFolder(ValueError):
    """The folder contains no such report; the message names the file and what is expected."""


@dataclass
class BitReport:
    """A bit as `tdbd bit --report` writes it."""

    folder: Path
    analysis: dict  # analysis.json
    points: np.ndarray  # (n, 3), m
    triangles: np.ndarray  # (k, 3)
    part: np.ndarray  # (k,), index into analysis["parts"]
    profile: np.ndarray  # (m, 2): r, z of the exposure profile, m

    @property
    def name(self):
        return self.analysis["name"]

    @property
    def cutters(self):
        return self.analysis["cutters"]

    @property
    def cones(self):
        return self.analysis.get("cones", [])

    @property
    def parts(self):
        return self.analysis["parts"]

    @cached_property
    def normals(self):
        """(k, 3, 3): of the corners of the triangles, for light."""
        return smooth_normals(self.points[self.triangles], self.part)

    @cached_property
    def centres(self):
        """(parts, 3): the mean of each part's corners; the frame of a part may be elsewhere, like that of a gage pad."""
        count = np.maximum(np.bincount(self.part, minlength=len(self.parts)), 1)
        means = self.points[self.triangles].mean(axis=1)
        return np.stack([np.bincount(self.part, x, len(self.parts)) for x in means.T], axis=1) / count[:, None]

    def corners(self, wanted=lambda part: True):
        """(corners, normals, part numbers), (k, 3, 3) twice and (k,), of the parts that are wanted."""
        take = np.isin(self.part, [i for i, p in enumerate(self.parts) if wanted(p)])
        return self.points[self.triangles[take]], self.normals[take], self.part[take]

    def column(self, key):
        """A key of all cutters, as an array; a null is not a number."""
        return np.array([c[key] for c in self.cutters], dtype=float)


def demand(folder, name):
    path = Path(folder) / name
    if not path.is_file():
        raise BadFolder(f"{path}: found no such file, expected one that `tdbd bit BIT -o {folder} --report` writes")
    return path


def read_analysis(folder):
    path = demand(folder, "analysis.json")
    try:
        analysis = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise BadFolder(f"{path}: {error}") from error
    for key in ("name", "gage_radius_m", "penetration_m_per_rev", "mass_kg", "cutters", "parts"):
        if not isinstance(analysis, dict) or key not in analysis:
            raise BadFolder(f"{path}: found no key {key}, expected what `tdbd bit BIT -o {folder} --report` writes")
    return analysis


def read_mesh(folder, count):
    """Points, triangles and the part number of each triangle."""
    path = demand(folder, "bit.vtp")
    try:
        mesh = rock_data.read(path)
    except (ArithmeticError, LookupError, TypeError, AttributeError, SyntaxError, ValueError) as error:
        raise BadFolder(f"{path}: found no mesh ({error}), expected that of a bit") from error
    part = mesh.cell_values.get("part")
    if part is None:
        raise BadFolder(f"{path}: found no triangles with a part number, expected those of a bit")
    if part.max() >= count:
        raise BadFolder(f"{path}: found part {part.max()}, expected the {count} parts of analysis.json")
    return mesh.points, mesh.triangles, part.astype(int)


def read_profile(folder):
    path = demand(folder, "profile.csv")
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))[1:]
    try:
        places = np.array(rows, dtype=float).reshape(-1, 2)
    except ValueError as error:
        raise BadFolder(f"{path}: {error}") from error
    if len(places) < 2:
        raise BadFolder(f"{path}: found {len(places)} places, expected a profile of at least two")
    return places


def read(folder):
    """The report in a folder. Raises BadFolder."""
    if not Path(folder).is_dir():
        raise BadFolder(f"{folder}: found no folder, expected one that `tdbd bit BIT -o {folder} --report` writes")
    analysis = read_analysis(folder)
    return BitReport(Path(folder), analysis, *read_mesh(folder, len(analysis["parts"])), read_profile(folder))
