"""Reads a 3-D page back, with nothing of what wrote it: its header and its numbers; and meshes that try what packs them."""

import base64
import html
import json
import re
import zlib

import numpy as np

STEPS = 65535


def header(page):
    return json.loads(re.search(r'<script type="application/json" id="run">(.*?)</script>', page, re.DOTALL)[1])


def text_of(page):
    """What can be read on it."""
    return html.unescape(re.sub(r"<[^>]*>", "", re.sub(r"<(script|style).*?</\1>", "", page, flags=re.DOTALL)))


class Numbers:
    """The arrays of a page, one after another."""

    def __init__(self, page):
        packed = re.search(r'<script type="text/plain" id="data">(.*?)</script>', page, re.DOTALL)[1]
        self.bytes, self.place = zlib.decompress(base64.b64decode(packed)), 0

    def next(self, rows, columns, old=None, continued=None):
        """(rows, columns): differences from the old rows that are continued; where there is none (-1), from the row before."""
        count = rows * columns
        planes = np.frombuffer(self.bytes, np.uint8, 4 * count, self.place).astype(np.int64).reshape(4, columns, rows)
        self.place += 4 * count
        unsigned = sum(planes[k] * 256**k for k in range(4))
        signed = np.where(unsigned % 2, -(unsigned + 1) // 2, unsigned // 2).T
        if old is None:
            return np.cumsum(signed, axis=0)
        found = signed + old[continued]
        for i in np.flatnonzero(continued < 0):
            found[i] = signed[i] + (found[i - 1] if i else 0)
        return found

    def continued(self, rows, old_rows):
        """Of each row the old one that it continues, or -1; a shift for every 64."""
        shifts = self.next(-(-rows // 64), 1)[:, 0]
        found = np.arange(rows) + shifts[np.arange(rows) // 64]
        found[(found < 0) | (found >= old_rows)] = -1
        return found


def renamed(corners, continued, old_count):
    """Old triangles by the numbers that their points have now; a point that is gone has that of the last one before it."""
    now, last = [], {int(v): k for k, v in reversed(list(enumerate(continued)))}
    for v in range(old_count):
        now.append(last.get(v, now[-1] if now else 0))
    return np.array(now)[corners]


def next_frame(numbers, entry, old):
    shapes = (entry["points"], 3), (entry["points"], 1), (entry["triangles"], 3)
    if not entry["over_time"]:
        return dict(zip(("points", "last", "corners"), [numbers.next(*shape) for shape in shapes]))
    rows = numbers.continued(entry["points"], len(old["points"]))
    points, last = numbers.next(*shapes[0], old["points"], rows), numbers.next(*shapes[1], old["last"], rows)
    same = numbers.continued(entry["triangles"], len(old["corners"]))
    return {"points": points, "last": last,
            "corners": numbers.next(*shapes[2], renamed(old["corners"], rows, len(old["points"])), same)}


def frames(page):
    """[{points, last, corners}] on the grid, and the bit's numbers {points, corners, colour}."""
    head, numbers, made = header(page), Numbers(page), []
    for entry in head["frames"]:
        made.append(next_frame(numbers, entry, made[-1] if made else None))
    bit = {name: numbers.next(head["bit"][count], columns)
           for name, count, columns in (("points", "points", 3), ("corners", "triangles", 3), ("colour", "triangles", 1), ("part", "triangles", 1))}
    if "areas" in head["bit"]:
        bit["area"] = numbers.next(head["bit"]["triangles"], 1)
    assert numbers.place == len(numbers.bytes), "the page has more numbers than its header lists"
    return made, bit


def placed(points, box):
    """m, of places on a grid."""
    return np.array(box["origin"]) + np.array(box["size"]) * points / STEPS


def strip(count):
    """A mesh of triangles in a row, its points in order: {points, corners, last}."""
    places = np.arange(count)
    points = np.stack([137 * places % 65536, 300 * (places % 2), 7 * places % 1000], axis=1)
    return points, np.stack([places[:-2], places[1:-1], places[2:]], axis=1), places[:, None] % 5


def heap(random, count):
    """Points and triangles in random order: only the frame before predicts their positions."""
    return random.integers(0, 65536, (count, 3)), random.integers(0, count, (2 * count, 3)), random.integers(0, 9, (count, 1))


def without(mesh, gone):
    """The mesh without some points and their triangles, numbered again without gaps."""
    points, corners, last = mesh
    stays = ~np.isin(np.arange(len(points)), gone)
    number = np.cumsum(stays) - 1
    return points[stays], number[corners[stays[corners].all(axis=1)]], last[stays]


def collapsed(mesh, gone):
    """The mesh without some points; their triangles have the point before instead."""
    points, corners, last = mesh
    stays = ~np.isin(np.arange(len(points)), gone)
    return points[stays], (np.cumsum(stays) - 1)[corners], last[stays]


def grown(mesh, more):
    """The mesh and another one, whose points come after its own."""
    return (np.concatenate([mesh[0], more[0]]), np.concatenate([mesh[1], len(mesh[0]) + more[1]]), np.concatenate([mesh[2], more[2]]))


def changing_meshes():
    """One after another: points go, are collapsed, come, are shuffled; lists become short and long."""
    random = np.random.default_rng(1)
    whole = heap(random, 3000)
    fewer = without(whole, [0, 1, 500, 2999])
    less = collapsed(fewer, [7, 100, 101, 1500, 2000])
    more = grown(less, heap(random, 90))
    order = random.permutation(len(more[0]))
    shuffled = more[0][order], np.argsort(order)[more[1]], more[2][order]
    return [whole, fewer, less, more, shuffled, strip(3000), strip(40), strip(3), strip(700)]


def packed(pack, meshes):
    """(entries, data, deflated size of each) of meshes as the module `pack` packs them."""
    parts, entries, before = [], [], None
    for mesh in meshes:
        part, is_over_time = pack.frame(*mesh, before)
        parts.append(part)
        entries.append({"points": len(mesh[0]), "triangles": len(mesh[1]), "over_time": is_over_time})
        before = mesh
    return entries, base64.b64encode(pack.deflated(parts)).decode(), [len(zlib.compress(p)) for p in parts]
