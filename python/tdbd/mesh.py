"""Meshes: read, check, repair and write STL, OBJ, PLY and OFF files.

    solids = tdbd.mesh.read("bit.stl", unit="mm")
    found = tdbd.mesh.check(solids[0])
    if not found.sound:
        solids[0] = tdbd.mesh.repair(solids[0], weld="0.01 mm").solid
    tdbd.mesh.write("repaired.stl", solids)
"""

import collections
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tdbd import _core
from tdbd.errors import CaseError
from tdbd.surfaces import Surface

Length = str | float  #: "0.01 mm", "mm" (one of it), or a number of metres


def _metres(name: str, length: Length, least: float) -> float:
    """Returns a length in m. Raises ValueError that names the argument."""
    try:
        text = str(length)
        value = _core.to_si(f"1 {text}" if text.isalpha() else text, "m") if isinstance(length, str) else float(length)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    if not (np.isfinite(value) and value >= least and (value > 0 or least == 0)):
        raise ValueError(f"{name}: found {length}, expected a length {'>= 0' if least == 0 else '> 0'}")
    return value


class Solid(NamedTuple):
    """A body of a mesh file."""

    name: str
    vertices: np.ndarray  #: (n, 3) float64, m
    faces: np.ndarray  #: (m, 3) int32, counter-clockwise seen from outside

    def __repr__(self) -> str:
        return f"<tdbd.mesh.Solid {self.name!r}: {len(self.vertices)} vertices, {len(self.faces)} faces>"


class Defect(NamedTuple):
    """A defect and its place."""

    kind: str  #: "hole", "flipped triangle", "self-intersection", ...
    where: str  #: number and position (mm) of a vertex, edge or triangle


@dataclass(frozen=True)
class Check:
    """Statistics and defects of a mesh, SI."""

    vertices: int
    faces: int
    pieces: int  #: connected by edges
    closed: bool
    oriented: bool  #: all faces point outwards
    manifold: bool
    volume: float  #: m3; meaningless for an open mesh
    area: float  #: m2
    box: tuple[np.ndarray, np.ndarray]  #: lower and upper corner, m
    shortest_edge: float
    mean_edge: float
    longest_edge: float
    worst_quality: float  #: 1 for an equilateral triangle, 0 for one without area
    equal_points: int
    degenerate: int  #: faces without area
    duplicates: int
    open_edges: int
    flipped_edges: int
    non_manifold_edges: int
    non_manifold_vertices: int
    intersecting_pairs: int
    defects: tuple[Defect, ...]

    @property
    def sound(self) -> bool:
        """Whether the mesh bounds a solid: no defects."""
        return not self.defects

    def __repr__(self) -> str:
        kinds = collections.Counter(defect.kind for defect in self.defects)
        state = ", ".join(f"{kind}: {count}" for kind, count in kinds.items()) or f"sound, {1e9 * self.volume:.6g} mm3"
        return f"<tdbd.mesh.Check of {self.faces} faces, {self.pieces} pieces: {state}>"


class Repaired(NamedTuple):
    """A repaired solid and what was changed."""

    solid: Solid
    steps: list[tuple[str, int]]  #: what was changed, and how often; empty for a sound mesh

    def __repr__(self) -> str:
        done = ", ".join(f"{count} {what}" for what, count in self.steps) or "nothing to repair"
        return f"<tdbd.mesh.Repaired {self.solid.name!r}: {done}>"


def read(path: str | os.PathLike[str], unit: Length | None = None, *, weld: Length = 0.0) -> list[Solid]:
    """Reads the bodies of a mesh file.

    `unit` is the length of one unit of the file. The default is the unit that the header states,
    otherwise "1 mm", and "1 m" for the rock of a run. Named solids of an STL or OBJ file keep their
    names; other files are divided into closed pieces. Points up to `weld` apart are merged before
    that. Without it, a mesh whose triangles share no points falls into one piece per triangle.
    Raises CaseError with file and line, also for a `unit` that contradicts the header.
    """
    name = os.fspath(path)
    given = None if unit is None else _metres("unit", unit, least=np.finfo(float).tiny)
    otherwise = 1.0 if _core.is_rock_of_a_run(name) else 1e-3
    return [Solid(*solid) for solid in _core.read_solids(name, given, otherwise, _metres("weld", weld, least=0))]


def check(solid: Solid | Surface) -> Check:
    """Inspects a mesh and lists its defects. A mesh without defects bounds a solid."""
    numbers, defects = _core.inspect_mesh(solid.vertices, solid.faces)
    return Check(**numbers, defects=tuple(Defect(*defect) for defect in defects))


def repair(solid: Solid | Surface, weld: Length = 0.0) -> Repaired:
    """Repairs a mesh so that it bounds a solid. `weld` merges points up to this far apart.

    Raises CaseError if the mesh does not determine a solid. A sound mesh is returned bitwise unchanged.
    """
    name = solid.name if isinstance(solid, Solid) else "surface"
    (vertices, faces), steps, refusal = _core.repair_mesh(solid.vertices, solid.faces, _metres("weld", weld, least=0))
    if refusal:
        raise CaseError(f"solid {name}: cannot be repaired: {refusal}")
    return Repaired(Solid(name, vertices, faces), steps)


def write(path: str | os.PathLike[str], solids: Solid | Surface | Iterable[Solid], unit: Length = "1 mm", *,
          force: bool = False) -> None:
    """Writes bodies in the format of the extension (.stl as text, .obj, .ply, .off), in `unit`, which the header states.

    Raises FileExistsError if the file exists, unless `force` is True.
    """
    file = Path(path)
    if file.exists() and not force:
        raise FileExistsError(f"{file}: exists; force=True replaces it")
    scale = _metres("unit", unit, least=np.finfo(float).tiny)
    bodies: list[Any] = [solids] if isinstance(solids, (Solid, Surface)) else list(solids)
    named = [(body.name if isinstance(body, Solid) else "surface", body.vertices, body.faces) for body in bodies]
    _core.write_solids(os.fspath(path), named, scale)
