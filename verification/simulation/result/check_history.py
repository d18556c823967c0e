"""check_history.py FILE.nc ROWS: xarray opens the history of history_test.cpp and finds every bit.

ROWS -1: the one row with sections and contact areas.
"""

import sys

import numpy as np
import xarray

path, rows = sys.argv[1], int(sys.argv[2])
history = xarray.open_dataset(path, engine="netcdf4", decode_times=False)
if rows == -1:
    unknown = np.nan
    measures = {
        "contact_area": [[3e-6, 4e-6]], "contact_area_total": [7e-6],
        "section_area": [[1e-6, unknown]], "section_area_total": [unknown],
        "section_centroid_x": [[0.1, unknown]], "section_centroid_y": [[0.2, unknown]],
        "section_centroid_z": [[0.3, unknown]], "section_engaged_edge": [[4e-3, unknown]],
        "section_angle_of_attack": [[0.5, unknown]], "section_volume_rate": [[6e-7, unknown]],
        "section_edge_centroid_x": [[0.7, unknown]], "section_edge_centroid_y": [[0.8, unknown]],
        "section_edge_centroid_z": [[0.9, unknown]],
    }
    for name, values in measures.items():
        np.testing.assert_array_equal(history[name].values, values, err_msg=name)
        assert history[name].attrs.get("units") and history[name].attrs.get("long_name"), name
    assert history["section_area"].dims == ("time", "cutter"), history["section_area"].dims
    assert list(history["cutter_name"].values) == ["cutter-3", "cutter-7"]
    sys.exit(0)
t = 0.001 * np.arange(rows)
expected = {
    "time": t,
    "position_x": t / 11, "position_y": t / 13, "position_z": t / 17,
    "rotation_vector_x": t / 19, "rotation_vector_y": t / 23, "rotation_vector_z": t / 29,
    "rotation_angle": t / 31, "removed_volume_total": t / 37,
    "swept_vertices": 2.0 * np.arange(rows), "rock_triangles": 1000.0 + np.arange(rows),
    "removed_volume_by_part": np.stack([t / 3, t / 7], axis=1),
}
assert history.sizes == {"time": rows, "part": 2}, history.sizes
for name, values in expected.items():
    np.testing.assert_array_equal(history[name].values, values, err_msg=name)
assert list(history["part_name"].values) == ["cutter-1/face", "gage-pad-1"]
assert list(history["part_kind"].values) == ["face", "gage_pad"]
for name, variable in history.variables.items():
    assert variable.attrs.get("units") and variable.attrs.get("long_name"), f"{name}: no units or name"
assert set(history.variables) == set(expected) | {"part_name", "part_kind"}
