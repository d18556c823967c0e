"""The bit of a run as rigid bodies: its mesh at rest, and where the bodies are in each frame. SI units, z down."""

import csv
from pathlib import Path

import numpy as np

from figures import rock_data

HEAD = ["time [s]", "body", "x [m]", "y [m]", "z [m]", "xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"]


def bodies_of(mesh):
    """Of each point: 0 for the bit itself, 1 + k for its cone k."""
    bodies = np.zeros(len(mesh.points), int)
    if "cone" in mesh.cell_values:
        bodies[mesh.triangles.ravel()] = 1 + np.repeat(mesh.cell_values["cone"].astype(int), 3)
    return bodies


def poses(folder):
    """[(time, (bodies, 3, 4))] of the frames of a run, in order: from where a body is at rest to where it is. Raises ValueError."""
    path = Path(folder) / "bit_poses.csv"
    if not path.is_file():
        raise ValueError(f"{path}: found no such file, expected the poses that `tdbd run` writes")
    with open(path, encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    if head != HEAD or any(len(row) != len(HEAD) for row in rows):
        raise ValueError(f"{path}: found other columns, expected those of a table of poses that `tdbd run` writes")
    frames = []
    for time, body, *numbers in rows:
        try:
            pose = np.array(numbers, float)
        except ValueError as error:
            raise ValueError(f"{path}: {error}, expected numbers") from error
        if body == "bit":
            frames.append((float(time), []))
        frames[-1][1].append(np.column_stack([pose[3:].reshape(3, 3), pose[:3]]))
    return [(time, np.array(of_bodies)) for time, of_bodies in frames]


def moved(points, bodies, of_bodies):
    """Points of bodies where these poses take them."""
    p = of_bodies[bodies]
    return np.einsum("nij,nj->ni", p[:, :, :3], points) + p[:, :, 3]


def at_rest(mesh, end):
    """(mesh, body of each point): the bit in its own frame, its cones at angle 0, from where these poses took it. Raises ValueError."""
    bodies = bodies_of(mesh)
    if bodies.max() >= len(end):
        raise ValueError(f"found poses of {len(end)} bodies, expected {bodies.max() + 1}")
    back = end.transpose(0, 2, 1)[:, :3, :]  # of a rotation: its inverse
    shifts = -np.einsum("bij,bj->bi", back, end[:, :, 3])
    mesh.points = moved(mesh.points, bodies, np.concatenate([back, shifts[:, :, None]], axis=2))
    return mesh, bodies


def placed(mesh, bodies, of_bodies):
    """The mesh at rest where these poses take it."""
    return rock_data.Mesh(moved(mesh.points, bodies, of_bodies), mesh.triangles, mesh.point_values, mesh.cell_values)
