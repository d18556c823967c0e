"""check_rotate_history.py FOLDER ROWS CONES: the record of rotate_history_test.cpp, by its meaning."""

import csv
import sys

import numpy as np
import xarray

folder, rows, cones = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
h = xarray.open_dataset(folder + "/history.nc", engine="netcdf4", decode_times=False)
assert dict(h.sizes) == {"time": rows, "xyz": 3, "quaternion_part": 4, "cone": cones}, h.sizes
for name, variable in h.variables.items():
    assert variable.attrs.get("units") and variable.attrs.get("long_name"), name
np.testing.assert_allclose(h.time, 0.01 * np.arange(rows), rtol=1e-15)
assert list(h.xyz.values) == ["x", "y", "z"]

q = h.quaternion.values
np.testing.assert_allclose((q ** 2).sum(axis=1), 1.0, rtol=1e-14)
w, v = q[:, :1], q[:, 1:]


def turned(x):
    """Bit to space by the quaternion."""
    t = 2.0 * np.cross(v, x)
    return x + w * t + np.cross(v, t)


def rotated(x, by):
    """The same by the rotation vector (Rodrigues)."""
    angle = np.linalg.norm(by, axis=1, keepdims=True)
    n = by / angle
    dot = (n * x).sum(axis=1, keepdims=True)
    return x * np.cos(angle) + np.cross(n, x) * np.sin(angle) + n * dot * (1 - np.cos(angle))


def close(a, b):
    np.testing.assert_allclose(a, b, rtol=0, atol=1e-12)


ez = np.tile([0.0, 0.0, 1.0], (rows, 1))
close(h.axis_W, turned(ez))
close(h.axis_W, rotated(ez, h.rotation_vector.values))
close(h.space_momentum, turned(h.body_momentum.values))
axes = np.array([[k, 0.5, 0.6] for k in range(cones)]).reshape(cones, 3)
axes = axes / np.linalg.norm(axes, axis=1, keepdims=True)
W, inertia, axial = h.angular_velocity.values, np.diag([2.0, 2.6, 3.0]), 0.1
close(h.cone_momentum, axial * (h.cone_spin.values + W @ axes.T))
close(h.body_momentum, W @ inertia + axial * h.cone_spin.values @ axes)
relative = axial * h.cone_spin.values
kinetic = 0.5 * ((W @ inertia) * W).sum(axis=1) + (relative * (W @ axes.T)).sum(axis=1)
close(h.kinetic_energy, kinetic + 0.5 * (relative * h.cone_spin.values).sum(axis=1))
twist = h.twist.values
close(h.potential_energy, 3.0 * h.axis_W[:, 2] + 0.05 * twist ** 2)
close(h.total_energy, h.kinetic_energy + h.potential_energy)
assert np.abs(np.diff(twist)).max() < 0.1 and twist.max() > np.pi, "the twist is unwrapped"
assert np.abs(np.diff(h.total_energy)).max() < 1e-3

with open(folder + "/history.csv", encoding="utf-8") as file:
    head, *lines = csv.reader(file)
flat = [n for name, d in h.data_vars.items() if "time" in d.dims for n in (
    [name] if d.ndim == 1 else
    [f"{name}_{c}" for c in {"xyz": "xyz", "quaternion_part": "wxyz",
                             "cone": [str(k + 1) for k in range(cones)]}[d.dims[1]]])]
assert [n.split(" [")[0] for n in head] == ["time"] + flat, head
table = np.array(lines, dtype=float)
columns = [h[name].values.reshape(rows, -1) for name in ["time"] + [
    name for name, d in h.data_vars.items() if "time" in d.dims]]
np.testing.assert_array_equal(table, np.concatenate(columns, axis=1))
