"""layouts.py TDBD FOLDER: the sweep cases/sweeps/even-wear.toml, into layouts.csv: how unevenly the cutters of 32 layouts wear and what
they need, and the layouts that no other beats in both."""

import subprocess
import sys
from pathlib import Path

import xarray

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "reports"))
from study_tools import write_rows  # noqa: E402

RAD = 180.0 / 3.141592653589793
COLUMNS = {"overlap, axis": ("bit.set.design.overlap.axis", 1, 2), "overlap, nose": ("bit.set.design.overlap.nose", 1, 2),
           "overlap, shoulder": ("bit.set.design.overlap.shoulder", 1, 2), "back rake, axis, deg": ("bit.set.design.back_rake.axis", 1, 1),
           "back rake, nose, deg": ("bit.set.design.back_rake.nose", 1, 1),
           "back rake, shoulder, deg": ("bit.set.design.back_rake.shoulder", 1, 1),
           "scatter of worn volumes over their mean": ("wear.worn_volume_unevenness", 1, 4),
           "worn volume, mm3": ("wear.worn_volume_m3", 1e9, 2), "largest of a cutter, mm3": ("wear.largest_worn_volume_m3", 1e9, 3),
           "specific energy, MPa": ("mechanical_specific_energy_pa", 1e-6, 3), "weight on bit, kN": ("wob_mean_n", 1e-3, 3)}


def rows(table):
    for i in range(table.sizes["point"]):
        point = table.isel(point=i)
        if int(point["status"]) != 0:
            continue
        row = {"layout": i + 1}
        for label, (name, scale, digits) in COLUMNS.items():
            row[label] = round(float(point[name]) * scale, digits)
        row["on the front"] = "yes" if int(point["front"]) else ""
        yield row


if __name__ == "__main__":
    out = Path(sys.argv[2]).resolve() / "even-wear.nc"
    subprocess.run([sys.argv[1], "sweep", ROOT / "cases/sweeps/even-wear.toml", "-o", out], check=True)
    with xarray.open_dataset(out) as found:
        write_rows(HERE / "layouts.csv", sorted(rows(found), key=lambda r: r["scatter of worn volumes over their mean"]))
