"""Which row of the frame before each row of this one continues.

A frame numbers its points and triangles without gaps, in the order in which the run keeps them: one that goes shifts all that come
after it. So rows continue others in long pieces, each by one shift. As in the coding of films, blocks of rows look for the shift
under which they differ least.
"""

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
