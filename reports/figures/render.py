"""Pictures of triangles: a depth buffer in numpy with soft light, shade in corners and outlines.

No window system is needed, and the same triangles give the same picture.
"""

from dataclasses import dataclass, field

import numpy as np

CREASE = np.cos(np.radians(35.0))  # across a sharper edge the light does not run on
SAMPLES = 2  # to a side of a pixel
DIRECTIONS = 8  # in which the shade of corners looks around
FRAGMENTS = 2_000_000  # pixels tested at a time


def unit(v):
    v = np.asarray(v, dtype=float)
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


@dataclass(frozen=True)
class Camera:
    """A parallel projection: `toward` points to the viewer, `up` is up in the picture."""

    toward: tuple
    up: tuple
    centre: tuple
    width: float  # of the picture, in the scene's unit
    pixels: tuple  # wide, high

    def axes(self):
        """Right, up, toward as rows."""
        toward = unit(self.toward)
        right = unit(np.cross(self.up, toward))
        return np.array([right, np.cross(toward, right), toward])

    def project(self, points):
        """(x, y, depth) of points: x to the right and y down in samples, depth away from the viewer."""
        seen = (np.asarray(points) - np.asarray(self.centre)) @ self.axes().T
        wide, high = (SAMPLES * n for n in self.pixels)
        scale = wide / self.width
        return np.stack([0.5 * wide + scale * seen[..., 0], 0.5 * high - scale * seen[..., 1],
                         -scale * seen[..., 2]], axis=-1)

    def place(self, points):
        """(x, y) of points in pixels of the picture, for writing beside them."""
        return self.project(points)[..., :2] / SAMPLES


@dataclass
class Layer:
    """Triangles that are drawn together. Arrays have a row for each triangle."""

    corners: np.ndarray  # (k, 3, 3)
    colours: np.ndarray  # (k, 3), 0 to 1
    owners: np.ndarray  # (k,): an outline is drawn where the owner changes
    wires: bool = False  # whether the triangles' edges are drawn
    lift: np.ndarray = 0.0  # (k,) or one for all: how much nearer they are drawn, in the scene's unit
    normals: np.ndarray = field(default=None)  # (k, 3, 3), of the corners

    def __post_init__(self):
        if self.normals is None:
            self.normals = smooth_normals(self.corners, self.owners)


def joined(layers):
    fields = {name: np.concatenate([getattr(layer, name) for layer in layers])
              for name in ("corners", "colours", "owners", "normals")}
    lift = np.concatenate([np.broadcast_to(layer.lift, len(layer.corners)) for layer in layers])
    return Layer(**fields, wires=layers[0].wires, lift=lift)


def corners_by_place(owners, places):
    """Corners in an order in which those of one owner and place (integers) follow one another; of each
    corner, where its group begins in this order, and the size of the group."""
    low, high = places[:, 0] - places[:, 0].min(), places[:, 1] - places[:, 1].min()
    keys = places[:, 2], low * (high.max() + 1) + high, owners
    order = np.lexsort(keys)
    differs = np.any([np.diff(key[order]) != 0 for key in keys], axis=0)
    starts = np.concatenate([[0], np.flatnonzero(differs) + 1])
    sizes = np.diff(np.append(starts, len(order)))
    first, valence = np.empty_like(order), np.empty_like(order)
    first[order], valence[order] = np.repeat(starts, sizes), np.repeat(sizes, sizes)
    return order, first, valence


def smooth_normals(corners, owners):
    """Of each corner: the mean of the triangles that meet there without a crease between them."""
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-300)
    if not len(corners):
        return np.zeros((0, 3, 3))
    scale = 1e-7 * np.ptp(corners.reshape(-1, 3), axis=0).max()
    order, first, valence = corners_by_place(np.repeat(owners, 3), np.round(corners.reshape(-1, 3) / scale).astype(np.int64))
    sums = np.zeros((len(order), 3))
    triangle = np.arange(len(order)) // 3
    for k in range(valence.max()):
        own = np.flatnonzero(valence > k)
        other = triangle[order[first[own] + k]]
        meets = np.einsum("ij,ij->i", flat[triangle[own]], flat[other]) > CREASE
        sums[own[meets]] += area[other[meets]]
    length = np.linalg.norm(sums, axis=1, keepdims=True)
    return np.where(length > 0, sums / np.maximum(length, 1e-300), flat[triangle]).reshape(-1, 3, 3)


class Buffer:
    """What is nearest at each sample: depth, triangle, its barycentric coordinates."""

    def __init__(self, camera):
        self.wide, self.high = (SAMPLES * n for n in camera.pixels)
        count = self.wide * self.high
        self.depth, self.triangle = np.full(count, np.inf), np.full(count, -1)
        self.weights = np.zeros((count, 3))

    def draw(self, seen, triangles):
        """Triangles (their numbers) of projected corners, by their boxes' sizes."""
        low = np.clip(np.floor(seen[:, :, :2].min(axis=1)), 0, None).astype(int)
        high = np.minimum(np.ceil(seen[:, :, :2].max(axis=1)).astype(int), [self.wide, self.high])
        size = np.maximum(high - low, 0)
        grown = 2 ** np.ceil(np.log2(np.maximum(size, 1))).astype(int)
        visible = (size > 0).all(axis=1)
        for wide, tall in np.unique(grown[visible], axis=0):
            of_size = np.flatnonzero(visible & (grown == [wide, tall]).all(axis=1))
            step = max(1, FRAGMENTS // (wide * tall))
            for k in range(0, len(of_size), step):
                part = of_size[k:k + step]
                self.fill(seen[part], triangles[part], low[part], (wide, tall))

    def fill(self, seen, triangles, low, box):
        x = low[:, 0, None, None] + np.arange(box[0])[None, None, :]
        y = low[:, 1, None, None] + np.arange(box[1])[None, :, None]
        wb, wc = barycentric(seen, x + 0.5, y + 0.5)
        inside = (wb >= 0) & (wc >= 0) & (wb + wc <= 1) & (x < self.wide) & (y < self.high)
        which = np.nonzero(inside)
        weights = np.stack([1.0 - wb[which] - wc[which], wb[which], wc[which]], axis=1)
        depth = np.einsum("ij,ij->i", weights, seen[which[0], :, 2])
        sample = np.broadcast_to(y, inside.shape)[which] * self.wide + np.broadcast_to(x, inside.shape)[which]
        near = np.flatnonzero(depth < self.depth[sample])
        while len(near):  # of several fragments at one sample the last is stored: repeat for those that are nearer
            at = sample[near]
            self.depth[at], self.weights[at], self.triangle[at] = depth[near], weights[near], triangles[which[0][near]]
            near = near[depth[near] < self.depth[at]]


def barycentric(seen, x, y):
    """Second and third coordinate of samples in triangles (n, 3, 3), (n, tall, wide); nan in flat ones."""
    a, b, c = (seen[:, k, :2, None, None] for k in range(3))

    def twice_area(p, q, px, py):
        return (q[:, 0] - p[:, 0]) * (py - p[:, 1]) - (q[:, 1] - p[:, 1]) * (px - p[:, 0])
    whole = twice_area(a, b, c[:, 0], c[:, 1])
    whole = np.where(whole == 0, np.nan, whole)
    return twice_area(c, a, x, y) / whole, twice_area(a, b, x, y) / whole


class Shifted:
    """An image moved by up to `reach` samples; beyond its border it continues as at the border."""

    def __init__(self, image, reach):
        self.reach, self.shape = reach, image.shape
        self.wider = np.pad(image, [(reach, reach), (reach, reach)] + [(0, 0)] * (image.ndim - 2), mode="edge")

    def at(self, right, down):
        """Each sample's value is that of the one so far to the right and down. A view."""
        top, left = self.reach + down, self.reach + right
        return self.wider[top:top + self.shape[0], left:left + self.shape[1]]


def shade_of_corners(depth, reach):
    """1 in the open, less where the surroundings (within `reach` samples) are nearer.
    Of every second sample."""
    finite = np.where(np.isfinite(depth), depth, depth[np.isfinite(depth)].max() if np.isfinite(depth).any() else 0)
    finite = finite / 2  # depth in samples, which are twice as far apart here
    hidden, count = np.zeros_like(finite), 0
    around = Shifted(finite, int(np.ceil(reach)))
    for ring, radius in enumerate((0.25 * reach, 0.6 * reach, reach)):
        for k in range(DIRECTIONS):
            angle = 2 * np.pi * (k + 0.33 * ring) / DIRECTIONS
            right, down = round(radius * np.cos(angle)), round(radius * np.sin(angle))
            nearer = finite - around.at(right, down)
            rise = nearer / max(radius, 1.0)
            hidden += np.clip(rise - 0.15, 0, 1) * np.exp(-np.clip(nearer / (2.5 * reach), 0, None) ** 2)
            count += 1
    return 1.0 - 0.75 * np.clip(1.6 * hidden / count, 0, 1)


def outlines(depth, owner, facing):
    """How dark a line is at each sample: where depth jumps, the owner changes or the surface folds."""
    line = np.zeros(depth.shape)
    depths, owners, facings = (Shifted(image, 1) for image in (depth, owner, facing))
    for right, down in ((1, 0), (0, 1)):
        other = depths.at(right, down)
        both = np.isfinite(depth) & np.isfinite(other)
        jump = np.abs(np.where(both, depth, 0) - np.where(both, other, 0)) > 6.0
        edge = np.isfinite(depth) != np.isfinite(other)
        fold = both & (np.einsum("ijk,ijk->ij", facing, facings.at(right, down)) < CREASE)
        line = np.maximum(line, np.select([edge | (both & jump), both & (owner != owners.at(right, down)), fold],
                                          [0.75, 0.45, 0.3], 0.0))
    return line


def wires_of(seen, buffer, hit):
    """How dark the edge of a triangle is at each hit: from the distance to its nearest side, in samples."""
    corners = seen[buffer.triangle[hit]][:, :, :2]
    sides = np.stack([np.linalg.norm(corners[:, (k + 1) % 3] - corners[:, (k + 2) % 3], axis=1) for k in range(3)], axis=1)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    twice = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    distance = (buffer.weights[hit] * twice[:, None] / np.maximum(sides, 1e-9)).min(axis=1)
    return 0.85 * np.clip(1.4 - distance, 0, 1)


def lit(camera, layer):
    """(colour, depth) of each sample, (high, wide, 3) and (high, wide); depth is infinite beside the scene."""
    seen, axes = camera.project(layer.corners), camera.axes()
    seen[:, :, 2] -= (np.broadcast_to(layer.lift, len(seen)) * SAMPLES * camera.pixels[0] / camera.width)[:, None]
    ahead = np.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])[:, 2] < 0  # y runs down in a picture
    buffer, front = Buffer(camera), np.flatnonzero(ahead)
    buffer.draw(seen[front], front)
    hit = np.flatnonzero(buffer.triangle >= 0)
    triangle = buffer.triangle[hit]
    normals = unit(np.einsum("ij,ijk->ik", buffer.weights[hit], layer.normals[triangle]) @ axes.T + [0, 0, 1e-9])
    key, fill = unit([-0.55, 0.65, 0.75]), unit([0.8, -0.1, 0.5])
    diffuse = 0.40 + 0.56 * np.clip(normals @ key, 0, 1) + 0.22 * np.clip(normals @ fill, 0, 1)
    gleam = 0.22 * np.clip(normals @ unit(key + [0, 0, 1]), 0, 1) ** 24
    shape = (buffer.high, buffer.wide)
    depth = buffer.depth.reshape(shape)
    owner, facing = np.full(buffer.depth.shape, -1), np.zeros((len(buffer.depth), 3))
    owner[hit], facing[hit] = layer.owners[triangle], normals
    shade = shade_of_corners(depth[::2, ::2], 0.01 * buffer.wide).repeat(2, axis=0).repeat(2, axis=1)
    shade = shade[:buffer.high, :buffer.wide].ravel()[hit]
    line = outlines(depth, owner.reshape(shape), facing.reshape(*shape, 3)).ravel()[hit]
    if layer.wires:
        line = np.maximum(line, wires_of(seen, buffer, hit))
    colour = np.ones((len(buffer.depth), 3))
    colour[hit] = (layer.colours[triangle] * (diffuse * shade)[:, None] + gleam[:, None]) * (1 - line)[:, None]
    return np.clip(colour, 0, 1).reshape(*shape, 3), depth


def picture(camera, solid, ghosts=(), opacity=0.3):
    """(high, wide, 3), 0 to 1: a layer, and transparent layers over it."""
    colour, depth = lit(camera, solid)
    for ghost in ghosts:
        over, nearer = lit(camera, ghost)
        front = (nearer < depth)[:, :, None]
        colour = np.where(front, (1 - opacity) * colour + opacity * over, colour)
    high, wide = depth.shape[0] // SAMPLES, depth.shape[1] // SAMPLES
    return colour.reshape(high, SAMPLES, wide, SAMPLES, 3).mean(axis=(1, 3))
