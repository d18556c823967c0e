"""Whole numbers in few bytes: as differences, from the frame before or from the number before, in planes of bytes, deflated.

Between two frames most of a mesh stays where it is, so most differences are 0. `web/unpack.js` undoes what is done here.
"""

import zlib

import numpy as np

STEPS = 65535  # of a coordinate, from one side of its box to the other
LEVEL = 9  # of zlib


def grid(points):
    """(origin, size) of the box of points, m; no side is 0."""
    origin = points.min(axis=0)
    return origin, np.maximum(points.max(axis=0) - origin, 1e-9)


def on_grid(points, origin, size):
    """The nearest places of a grid: (n, 3), whole numbers; off by half a step at most."""
    return np.rint((points - origin) / size * STEPS).astype(np.int64)


def along(values):
    """Each row as its difference from the row before."""
    return np.diff(values, axis=0, prepend=0)


def over_time(values, before):
    """Each row as its difference from that row of the frame before; rows that it did not have, from the row before."""
    both = min(len(values), len(before))
    return np.concatenate([values[:both] - before[:both], along(values)[both:]])


def differences(values, before=None):
    """(differences, whether they are from the frame before): of both kinds the smaller."""
    still = along(values)
    if before is None:
        return still, False
    moved = over_time(values, before)
    return (moved, True) if np.count_nonzero(moved) < np.count_nonzero(still) else (still, False)


def planes(differences):
    """Four planes of bytes, the lowest first, column after column; small numbers of either sign leave the upper ones empty."""
    signed = differences.T.ravel().astype(np.int64)
    unsigned = ((signed << 1) ^ (signed >> 63)).astype("<u4")
    return unsigned.view(np.uint8).reshape(-1, 4).T.tobytes()


class Packer:
    """Arrays one after another. `add` returns what the reader must know of each beside its shape."""

    def __init__(self):
        self.parts = []

    def add(self, values, before=None):
        values = np.asarray(values, np.int64)
        values = values.reshape(len(values), -1)
        found, is_over_time = differences(values, None if before is None else np.asarray(before, np.int64).reshape(len(before), -1))
        self.parts.append(planes(found))
        return is_over_time

    def bytes(self):
        return zlib.compress(b"".join(self.parts), LEVEL)
