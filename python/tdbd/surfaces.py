"""The rock's surface as arrays."""

from typing import NamedTuple

import numpy as np


class Surface(NamedTuple):
    """A copy of a triangulated surface. Space frame: origin at the bit's nose at t = 0, z down the hole."""

    vertices: np.ndarray  #: (n, 3) float64, m
    faces: np.ndarray  #: (m, 3) int32, vertices of each triangle; normals point out of the rock

    def __repr__(self) -> str:
        if not len(self.vertices):
            return "<tdbd.Surface without vertices>"
        size = 1e3 * (self.vertices.max(axis=0) - self.vertices.min(axis=0))
        return (f"<tdbd.Surface: {len(self.vertices)} vertices, {len(self.faces)} faces, "
                f"{size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} mm>")

    @property
    def depth(self) -> np.ndarray:
        """(n,) Depth of every vertex below the start of the bit, m."""
        return self.vertices[:, 2]
