"""Whole numbers in few bytes: as differences from the frame before, or from the row before, in planes of bytes, deflated.

Between two frames most of a mesh stays where it is, so most differences are 0. `web/unpack.js` undoes what is done here.
"""

import zlib

import numpy as np

import page3d_match as match

STEPS = 65535  # of a coordinate, from one side of its box to the other
LEVEL, QUICK_LEVEL = 9, 1  # of zlib: of what is kept, of what is weighed
NEAR = 400  # steps in the plane across the hole, some 1.3 mm: a point that the bit moved is still itself


def grid(points):
    """(origin, size) of the box of points, m; no side is 0."""
    origin = points.min(axis=0)
    return origin, np.maximum(points.max(axis=0) - origin, 1e-9)


def on_grid(points, origin, size):
    """The nearest places of a grid: (n, 3), whole numbers; off by half a step at most."""
    return np.rint((points - origin) / size * STEPS).astype(np.int64)


def planes(differences):
    """Four planes of bytes, the lowest first, column after column; small numbers of either sign leave the upper ones empty."""
    signed = differences.T.ravel().astype(np.int64)
    unsigned = ((signed << 1) ^ (signed >> 63)).astype("<u4")
    return unsigned.view(np.uint8).reshape(-1, 4).T.tobytes()


def along(values):
    """Each row as its difference from the row before."""
    return planes(np.diff(values.reshape(len(values), -1), axis=0, prepend=0))


def continuing(values, old, rows):
    """Each row as its difference from the old one that it continues; a new one as that from the row before."""
    values, old = (a.reshape(len(a), -1) for a in (values, old))
    before = np.concatenate([np.zeros_like(values[:1]), values[:-1]])
    return planes(values - np.where(rows[:, None] < 0, before, old[rows]))


def alone(points, corners, last):
    return b"".join(map(along, (points, last, corners)))


def over_time(points, corners, last, before):
    """Each row as its difference from the row of the frame before that it continues; triangles by their corners' numbers now."""
    old_points, old_corners, old_last = before
    moved = match.shifts(points[:, :2], old_points[:, :2], NEAR)
    rows = match.rows_before(moved, len(points), len(old_points))
    named = match.names_now(rows, len(old_points))[old_corners]
    turned = match.shifts(corners, named, 0)
    same = match.rows_before(turned, len(corners), len(named))
    return b"".join((along(moved), continuing(points, old_points, rows), continuing(last, old_last, rows),
                     along(turned), continuing(corners, named, same)))


def frame(points, corners, last, before):
    """(bytes, whether they are differences from the frame before): whichever deflates to less."""
    ways = [(alone(points, corners, last), False)]
    if before is not None:
        ways.append((over_time(points, corners, last, before), True))
    return min(ways, key=lambda way: len(zlib.compress(way[0], QUICK_LEVEL)))


def deflated(parts):
    return zlib.compress(b"".join(parts), LEVEL)
