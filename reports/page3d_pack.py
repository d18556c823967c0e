"""Packs the frames of a 3-D page: whole numbers as differences from the frame before, or from the row before, in planes of bytes,
deflated. `web/unpack.js` reads them.

Between two frames most of a mesh stays where it is, so most differences are 0. A frame numbers its points and triangles without gaps,
in the order in which the run keeps them: a point that is removed shifts all that come after it. So rows continue others in long pieces,
each by one shift. As in the coding of films, blocks of rows search for the shift under which they differ least.
"""

import zlib

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

BLOCK = 64  # rows with one shift
BETTER = 0.5  # share of the rows that differ to which another shift must bring them, or chance would choose
FEW = 0.1  # share of a block: more rows that differ, and another shift is looked for
REACH = 48  # how far from the shift of the block before it is looked for


def misses(block, old, first, low, high, near):
    """(shifts, rows of a block at `first` that differ by more than `near` under each), of shifts from low to high that stay inside."""
    low, high = max(low, -first), min(high, len(old) - len(block) - first)
    if high < low:
        return np.zeros(0, int), np.zeros(0, int)
    windows = sliding_window_view(old[first + low:first + high + len(block)], len(block), axis=0)
    return np.arange(low, high + 1), (np.abs(windows - block.T[None]) > near).any(axis=1).sum(axis=1)


def shifts(new, old, near):
    """Of each block: its shift. That of the block before is kept while few rows differ, or no other is much better."""
    found, shift = [], 0
    for first in range(0, len(new), BLOCK):
        block = new[first:first + BLOCK]
        _, kept = misses(block, old, first, shift, shift, near)
        if not len(kept) or kept[0] > FEW * len(block):
            tried, missed = misses(block, old, first, shift - REACH, shift + REACH, near)
            if len(tried) and (not len(kept) or missed.min() < BETTER * kept[0]):
                shift = tried[np.lexsort((np.abs(tried - shift), missed))[0]]
        found.append(shift)
    return np.array(found, np.int64)


def rows_before(found, count, old_count):
    """Of each of `count` rows: the row that it continues, or -1: it is new."""
    rows = np.arange(count) + np.repeat(found, BLOCK)[:count]
    return np.where((0 <= rows) & (rows < old_count), rows, -1)


def names_now(rows, old_count):
    """Of each point of the frame before: its number now. One that is gone has that of the last before it that is not."""
    now = np.full(old_count, -1)
    old = np.flatnonzero(rows >= 0)[::-1]
    now[rows[old]] = old
    last = np.maximum.accumulate(np.where(now < 0, -1, np.arange(old_count)))
    return np.where(last < 0, 0, now[last])


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
    moved = shifts(points[:, :2], old_points[:, :2], NEAR)
    rows = rows_before(moved, len(points), len(old_points))
    named = names_now(rows, len(old_points))[old_corners]
    turned = shifts(corners, named, 0)
    same = rows_before(turned, len(corners), len(named))
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
