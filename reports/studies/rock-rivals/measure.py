#!/usr/bin/python3
"""Volumes of revolutions over the exact one, as verify_rock_claims prints them. Writes revolutions.csv and wall.csv beside itself,
ten seconds; wants a release build.

    measure.py [--build FOLDER]
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_runs import build_folder, found, found_all, printed, write_csv  # noqa: E402

N = r"([-+]?\d+\.\d+)"


def main():
    program = build_folder(__doc__) / "verification/claims/verify_rock_claims"
    told = printed(program, "RockRivals.volume_of_a_revolution_*")
    [below] = found(rf"scalloped wall: {N} % of pi R\^2 d", told)
    rows = found_all(rf"edges {N} mm: {N} {N} {N} %, mean {N} %, rms {N} %", told)
    write_csv(HERE / "wall.csv", ["exact volume within the scalloped wall over pi R^2 d, less 1, %"], [f"{below:.4f}"])
    write_csv(HERE / "revolutions.csv", ["edges, mm", "second, %", "third, %", "fourth, %", "mean, %", "rms, %"],
              *([f"{edge:.1f}", *(f"{e:+.3f}" for e in errors), f"{rms:.3f}"] for edge, *errors, rms in rows))


if __name__ == "__main__":
    main()
