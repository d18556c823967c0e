"""Reads a TDBD result folder: the rock's surface, the summary, the bit's cutters. SI units."""

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


@dataclass
class Surface:
    """Triangles of the rock in space, z down."""

    points: np.ndarray  # (n, 3), m
    triangles: np.ndarray  # (k, 3), indices of points
    depth: np.ndarray  # (n,), m

    def corners(self):
        """(k, 3, 3): triangle, corner, coordinate; m."""
        return self.points[self.triangles]

    def triangle_depth(self):
        """Mean depth of each triangle, m."""
        return self.depth[self.triangles].mean(axis=1)


@dataclass
class Cutter:
    """One cutter of bit.json with what its parts removed."""

    name: str
    tip_radius: float  # m
    blade: int
    zone: str
    volumes: np.ndarray = field(default_factory=lambda: np.zeros(0))  # m3 per revolution


def read_surface(path):
    """The surface in a .vtp file; depth is z where the file has no depth_m."""
    if not path.is_file():
        raise SystemExit(f"{path}: no such file")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfPolys() == 0:
        raise SystemExit(f"{path}: no triangles")
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    depth = mesh.GetPointData().GetArray("depth_m")
    return Surface(points, triangles, points[:, 2] if depth is None else vtk_to_numpy(depth))


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
