"""The rock's surface as arrays."""

from typing import NamedTuple

import numpy as np


class Surface(NamedTuple):
    """A copy of a triangulated surface. Space frame: origin at the bit's nose at t = 0, z down the hole."""

    vertices: np.ndarray  #: (n, 3) float64, m
    faces: np.ndarray  #: (m, 3) int32, vertices of each triangle; normals point out of the rock

    @property
    def depth(self) -> np.ndarray:
        """(n,) Depth of every vertex below the start of the bit, m."""
        return self.vertices[:, 2]
