"""Reads the frames that `tdbd run` writes: surfaces of rock, meshes of the bit in space. SI units, z down."""

from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

TYPES = {"Float64": np.float64, "Int32": np.int32}
RAW = b'<AppendedData encoding="raw">'


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


def blocks(path):
    """{group: {name: values}} of the arrays behind the head of a .vtp file of `tdbd` (src/mesh/files/vtp). VTK reads
    such files too, as the tests of that module show; the demo avoids its 150 packages."""
    head, _, appended = Path(path).read_bytes().partition(RAW)
    if not appended:
        raise ValueError(f"{path}: found no raw appended data, expected a frame that `tdbd run` writes")
    data = appended[appended.index(b"_") + 1:]
    piece = ElementTree.fromstring(head + b"</VTKFile>").find("PolyData/Piece")
    return {group.tag: {array.get("Name"): block(data, array) for array in group} for group in piece}


def block(data, array):
    start, kind = int(array.get("offset")), TYPES[array.get("type")]
    count = int.from_bytes(data[start:start + 8], "little") // np.dtype(kind).itemsize
    return np.frombuffer(data, kind, count, start + 8)


def read(path):
    """The mesh in a .vtp file. Raises ValueError when there is none."""
    if not Path(path).is_file():
        raise ValueError(f"{path}: found no such file, expected a frame that `tdbd run` writes")
    groups = blocks(path)
    triangles = groups["Polys"]["connectivity"].reshape(-1, 3)
    if not len(triangles):
        raise ValueError(f"{path}: found no triangles")
    return Mesh(groups["Points"]["Points"].reshape(-1, 3).copy(), triangles, groups.get("PointData", {}),
                groups.get("CellData", {}))


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
