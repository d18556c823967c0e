#!/usr/bin/python3
"""What spokes of Hanson and Hansen's remove in a revolution, as verify_rock_claims prints it. Writes volume.csv beside itself, some
seconds; wants a release build.

    measure.py [--build FOLDER]
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_runs import build_folder, found, printed, write_csv  # noqa: E402

N = r"([-+]?\d+\.\d+)"


def main():
    told = printed(build_folder(__doc__) / "verification/claims/verify_rock_claims", "Spokes.remove_in_a_revolution_*")
    numbers = found(rf"over pi R\^2 d: wall {N}, removed {N}, respaced {N}", told)
    write_csv(HERE / "volume.csv", ["within the scalloped wall", "removed", "respaced"], [f"{n:.5f}" for n in numbers])


if __name__ == "__main__":
    main()
