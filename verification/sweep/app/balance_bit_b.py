"""The shipped design balances bit B: its imbalance falls from 5 % and more to less than 2 %, by the planar model and by that of TDBD.
balance_bit_b.py TDBD FOLDER [CSV]: the third argument is a file for the numbers

The planar model with the force law of the case follows the drilled imbalance: the ranks of the best points, of a sample of the
others and of the unchanged bit are correlated."""

import csv
import pathlib
import shutil
import subprocess
import sys

SWEEPS = pathlib.Path(__file__).resolve().parents[3] / "cases" / "sweeps"


def swept(tdbd, design, table):
    """The output, the points that were run, and the rows of NAME_filter.csv."""
    done = subprocess.run([tdbd, "sweep", design, "-o", table, "--threads", "2"], check=True, capture_output=True, text=True)
    rows = [row for row in csv.DictReader(table.with_suffix(".csv").open()) if row["status"] == "done"]
    return done.stdout, rows, list(csv.DictReader(table.with_name(table.stem + "_filter.csv").open()))


def rank_correlation(rows):
    """Spearman's, of the planar and the drilled imbalance; no two values are equal."""
    columns = [[float(row[name]) for row in rows] for name in ("planar.imbalance", "imbalance")]
    ranks = [[sorted(column).index(x) for x in column] for column in columns]
    n = len(rows)
    return 1 - 6 * sum((a - b) ** 2 for a, b in zip(*ranks)) / (n * (n * n - 1))


def write_csv(before, by_planar, by_ours, path):
    """Azimuths, and the results of both models for the shipped bit, for the optimum of the planar model and for that of TDBD."""
    turned = [name for name in by_ours if "blade" in name]
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["bit B", "blades 2 to 5 turned, deg", "planar imbalance, %", "imbalance, %", "weight's deviation, N", "specific energy, MPa"])
        for name, row in (("as it is", before), ("the planar model's best", by_planar), ("the best of 32", by_ours)):
            out.writerow([name, ", ".join(f"{float(row.get(t, 0)):.2f}" for t in turned), f"{100 * float(row['planar.imbalance']):.2f}",
                          f"{100 * float(row['imbalance']):.2f}", f"{float(row['wob_std_n']):.1f}",
                          f"{1e-6 * float(row['mechanical_specific_energy_pa']):.2f}"])


def main(tdbd, folder, table=None):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    printed, rows, filtered = swept(tdbd, SWEEPS / "balance-bit-b.toml", folder / "after.nc")
    best_rows = [row for row in filtered if row["run as"] == "best"]
    [before] = [row for row in filtered if row["run as"] == "unchanged"]
    assert len(rows) == 32 and len(best_rows) == 24 and len(filtered) == 33
    best = min(rows, key=lambda row: float(row["imbalance"]))
    if table:
        write_csv(before, min(rows, key=lambda row: float(row["planar.imbalance"])), best, table)
    text = ", ".join(f"{name} {100 * float(before[name]):.2f} % before, {100 * float(best[name]):.2f} % after"
                     for name in ("planar.imbalance", "imbalance"))
    rho, rho_best = rank_correlation(filtered), rank_correlation(best_rows)
    assert f"rank correlation of planar.imbalance and imbalance: {rho:.2f} for all 33 points, {rho_best:.2f} for the 24" in printed, printed
    assert float(before["imbalance"]) > 0.05 and float(before["planar.imbalance"]) > 0.05, text
    assert rho > 0.5, rho
    assert float(best["imbalance"]) < 0.02 and best["front"] == "1", text
    assert all(float(row["planar.imbalance"]) < float(before["planar.imbalance"]) for row in best_rows)
    print(f"balance_bit_b: {text}; rank correlation {rho:.2f} of 33 bits, {rho_best:.2f} of the best 24; "
          f"{sum(row['front'] == '1' for row in rows)} are on the front")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]), *sys.argv[3:])
