"""Figures 4.7 to 4.9: a vertical slice of the mesh before and after drilling, for one rule of update directions."""

import numpy as np

from figures import results, rock_data, style

MM = 1e3
MAGENTA = "#d6139a"


def slice_of(mesh, edge):
    """Indices of the vertices nearest to the half-plane y = 0, x > 0, one of each ring of the start, from the axis
    up the wall."""
    x, y, z = mesh.points.T
    beside = np.flatnonzero((np.abs(y) < 0.7 * edge) & (x > -0.25 * edge))
    rings = np.round(np.stack([np.hypot(x, y), -z], axis=1)[beside] / (0.05 * edge))  # all of a ring in one place
    order = np.argsort(np.abs(y[beside]), kind="stable")
    _, first = np.unique(rings[order], axis=0, return_index=True)  # by radius, on the wall upwards
    return beside[order][first]


def rz(mesh, numbers):
    return np.hypot(*mesh.points[numbers, :2].T) * MM, mesh.points[numbers, 2] * MM


def spacing(r, z):
    return np.hypot(np.diff(r), np.diff(z))


def draw_slice(axes, r, z, words):
    axes.plot(r, z, "o-", color=style.BLACK, markersize=2.2, linewidth=0.7)
    axes.set(xlabel="radius (mm)", aspect="equal")
    axes.set_title(words, loc="left")


def draw(inputs):
    start, end = inputs.folders()
    before, after = rock_data.final(start), rock_data.final(end)
    if len(before.points) != len(after.points):
        raise ValueError(f"{end}: the mesh was maintained, its vertices cannot be followed")
    edge = np.median(np.linalg.norm(np.diff(before.corners[:, :2], axis=1), axis=2))
    numbers = slice_of(before, edge)
    (r0, z0), (r1, z1) = rz(before, numbers), rz(after, numbers)
    figure, (left, right) = style.panels(1, 2, (9.6, 4.9), sharex=True, sharey=True)
    moved = np.hypot(r1 - r0, z1 - z0) > 0.05 * MM * edge
    way = np.stack([r1 - r0, z1 - z0])[:, moved] / np.hypot(r1 - r0, z1 - z0)[moved]
    draw_slice(left, r0, z0, "before, with the way that each vertex went")
    left.quiver(r0[moved], z0[moved], *(2.2 * MM * edge * way), color=MAGENTA, angles="xy", scale_units="xy", scale=1.0, width=0.003)
    run, ratio = results.summary(end), spacing(r1, z1) / (MM * edge)
    draw_slice(right, r1, z1, f"after {run['revolutions']:.3g} revolutions without maintenance:\nneighbours "
               f"{ratio.min():.2f} to {ratio.max():.1f} edge lengths apart")
    left.set_ylim(z1.max() + 4, -70)
    left.set_xlim(-4, 122)
    left.set_ylabel("z (mm, down)")
    return figure
