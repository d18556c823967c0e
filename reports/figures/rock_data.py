"""Reads the frames that `tdbd run` writes: surfaces of rock, meshes of the bit in space. SI units, z down."""

from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


@dataclass
class Mesh:
    """Triangles with the values that a file has of its points and of its cells."""

    points: np.ndarray  # (n, 3), m
    triangles: np.ndarray  # (k, 3)
    point_values: dict = field(default_factory=dict)  # name: (n,)
    cell_values: dict = field(default_factory=dict)  # name: (k,)

    @property
    def corners(self):
        """(k, 3, 3): triangle, corner, coordinate; m."""
        return self.points[self.triangles]

    @property
    def normals(self):
        """(k, 3), unit."""
        c = self.corners
        n = np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])
        return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)

    def of_triangles(self, name):
        """A point value, as the mean over each triangle's corners."""
        return self.point_values[name][self.triangles].mean(axis=1)


def values(data):
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).astype(float) for i in range(data.GetNumberOfArrays())}


def read(path):
    """The mesh in a .vtp file. Raises ValueError when there is none."""
    if not Path(path).is_file():
        raise ValueError(f"{path}: found no such file, expected a frame that `tdbd run` writes")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    if not mesh.GetNumberOfPolys():
        raise ValueError(f"{path}: found no triangles")
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return Mesh(vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), triangles, values(mesh.GetPointData()),
                values(mesh.GetCellData()))


def final(folder, what="rock"):
    """The rock, or the bit, at the end of a run."""
    return read(Path(folder) / "frames" / f"{what}_final.vtp")


def frames(folder, what="rock"):
    """[(time, path)] of all frames of a run, in order; s."""
    collection = Path(folder) / f"{what}.pvd"
    if not collection.is_file():
        raise ValueError(f"{collection}: found no such file, expected one that `tdbd run` writes")
    sets = ElementTree.parse(collection).getroot().iter("DataSet")
    return [(float(s.get("timestep")), Path(folder) / s.get("file")) for s in sets]
