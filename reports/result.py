"""Reads the files of a result folder: the surface of the rock, also as heights on a grid, the summary, the cutters of the bit. SI units."""

import json
import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from figures import rock_data

@dataclass
class Cutter:
    """One cutter of bit.json, with the volumes that its parts removed."""

    name: str
    tip_radius: float  # m
    blade: int
    zone: str
    volumes: np.ndarray = field(default_factory=lambda: np.zeros(0))  # m3 per revolution


def read_surface(path):
    """The surface of the rock in a .vtp file. If the file has no depth_m, it is set to z. Raises ValueError."""
    surface = rock_data.read(path)
    surface.point_values.setdefault("depth_m", surface.points[:, 2])
    return surface


def read_json(path):
    """Raises ValueError if there is no such file."""
    if not path.is_file():
        raise ValueError(f"{path}: found no such file, expected one that tdbd writes")
    return json.loads(path.read_text())


def full_revolutions(summary):
    """The number of complete revolutions."""
    return int(np.floor(summary["revolutions"] + 1e-9))


def read_cutters(folder, summary):
    """The cutters of bit.json, sorted by tip radius, each with the sum of the volumes of its parts."""
    volumes = summary.get("removed_volume_by_part_by_revolution_m3", {})
    cutters = []
    for row in read_json(Path(folder) / "bit.json").get("cutters", []):
        own = [v for part, v in volumes.items() if part.split("/")[0] == row["name"]]
        total = np.sum(own, axis=0) if own else np.zeros(0)
        cutters.append(
            Cutter(row["name"], row["tip_radius_m"], row.get("blade", 0), row.get("zone", ""), total)
        )
    return sorted(cutters, key=lambda c: c.tip_radius)


def read_ply(path):
    """Positions and triangles of a binary or text PLY file that TDBD wrote."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:end].decode()
    vertices = int(re.search(r"element vertex (\d+)", head)[1])
    faces = int(re.search(r"element face (\d+)", head)[1])
    if "format ascii" in head:
        numbers = data[end:].split()
        x = np.array(numbers[:3 * vertices], dtype=float).reshape(-1, 3)
        t = np.array(numbers[3 * vertices:], dtype=int).reshape(faces, 4)[:, 1:]
        return x, t
    x = np.frombuffer(data, "<f8", 3 * vertices, end).reshape(-1, 3)
    kind = np.dtype([("n", "u1"), ("v", "<i4", 3)])
    return x, np.frombuffer(data, kind, faces, end + 24 * vertices)["v"]


def heights(x, t, reach, cell):
    """z (m) of the highest triangle at each point of a square grid (z is down), from -reach to reach (m), with the spacing `cell`."""
    n = int(2 * reach / cell) + 1
    z = np.full((n, n), np.inf)
    a, b, c = ((x[t[:, k]] + [reach, reach, 0]) / [cell, cell, 1] for k in range(3))
    lo = np.ceil(np.minimum(np.minimum(a, b), c)[:, :2]).astype(int)
    hi = np.floor(np.maximum(np.maximum(a, b), c)[:, :2]).astype(int)
    twice = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    most = (hi - lo).max(axis=0)
    for i in range(most[0] + 1):
        for k in range(most[1] + 1):
            p = lo + [i, k]
            inside = (p <= hi).all(axis=1) & (p >= 0).all(axis=1) & (p < n).all(axis=1) & (abs(twice) > 1e-12)
            s = np.flatnonzero(inside)
            q, d = p[s].astype(float), twice[s]
            def weight(u, v):
                return ((v[s, 0] - u[s, 0]) * (q[:, 1] - u[s, 1]) - (v[s, 1] - u[s, 1]) * (q[:, 0] - u[s, 0])) / d
            wc, wa = weight(a, b), weight(b, c)
            wb = 1 - wa - wc
            hit = (wa >= -1e-9) & (wb >= -1e-9) & (wc >= -1e-9)
            s = s[hit]
            depth = wa[hit] * a[s, 2] + wb[hit] * b[s, 2] + wc[hit] * c[s, 2]
            np.minimum.at(z, (p[s, 0], p[s, 1]), depth)
    return z


def distances(z, other, reach, cell, least, most):
    """Distances of a surface from another one, m: the vertical distance times the cosine of the slope, at the points of the grid with
    least <= r <= most (m)."""
    at = np.arange(z.shape[0]) * cell - reach
    r = np.hypot(at[:, None], at[None, :])
    with np.errstate(invalid="ignore"):  # outside the rock
        slope = np.hypot(*np.gradient(z, cell))
        distance = abs(other - z) / np.sqrt(1 + slope**2)
    return distance[(r >= least) & (r <= most) & np.isfinite(distance)]
