"""The shipped design balances bit B: its imbalance falls from 5 % and more to less than 2 %, by the planar model and by that of TDBD.
balance_bit_b.py TDBD FOLDER [CSV]: the third argument is a file for the numbers"""

import csv
import pathlib
import shutil
import subprocess
import sys

SWEEPS = pathlib.Path(__file__).resolve().parents[3] / "cases" / "sweeps"


def swept(tdbd, design, table):
    subprocess.run([tdbd, "sweep", design, "-o", table, "--quiet", "--threads", "2"], check=True)
    return [row for row in csv.DictReader(table.with_suffix(".csv").open()) if row["status"] == "done"]


def write_csv(before, by_planar, by_ours, path):
    """Azimuths, and the results of both models for the shipped bit, for the optimum of the planar model and for that of TDBD."""
    turned = [name for name in by_ours if "blade" in name]
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["bit B", "blades 2 to 5 turned, deg", "planar imbalance, %", "imbalance, %", "weight's deviation, N", "specific energy, MPa"])
        for name, row in (("as it is", before), ("the planar model's best", by_planar), ("the best of 24", by_ours)):
            out.writerow([name, ", ".join(f"{float(row.get(t, 0)):.2f}" for t in turned), f"{100 * float(row['planar.imbalance']):.2f}",
                          f"{100 * float(row['imbalance']):.2f}", f"{float(row['wob_std_n']):.1f}",
                          f"{1e-6 * float(row['mechanical_specific_energy_pa']):.2f}"])


def main(tdbd, folder, table=None):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    shipped = (SWEEPS / "balance-bit-b.toml").read_text()
    as_it_is = shipped[:shipped.index("[[factors]]")].replace('"../', f'"{SWEEPS.parent}/')
    as_it_is = as_it_is.replace('sampling = "sobol"\nsamples = 512\n', "").replace("keep = 24", "keep = 1")
    (folder / "before.toml").write_text(as_it_is + '[[factors]]\nkey = "bit.set.adjust.azimuth"\nvalues = ["0 deg"]\n')
    [before] = swept(tdbd, folder / "before.toml", folder / "before.nc")
    rows = swept(tdbd, SWEEPS / "balance-bit-b.toml", folder / "after.nc")
    assert len(rows) == 24
    best = min(rows, key=lambda row: float(row["imbalance"]))
    if table:
        write_csv(before, min(rows, key=lambda row: float(row["planar.imbalance"])), best, table)
    text = ", ".join(f"{name} {100 * float(before[name]):.2f} % before, {100 * float(best[name]):.2f} % after"
                     for name in ("planar.imbalance", "imbalance"))
    assert float(before["imbalance"]) > 0.05 and float(before["planar.imbalance"]) > 0.07, text
    assert float(best["imbalance"]) < 0.02 and best["front"] == "1", text
    assert all(float(row["planar.imbalance"]) < float(before["planar.imbalance"]) for row in rows)
    print(f"balance_bit_b: {text}; of 24 that the planar model finds best {sum(row['front'] == '1' for row in rows)} are on the front")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]), *sys.argv[3:])
