#!/usr/bin/python3
"""The memory of a rock, as verify_memory counts it. Writes memory.csv beside itself, some seconds; wants a release build.

    measure.py [--build FOLDER]
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_runs import build_folder, found, printed, write_csv  # noqa: E402


RUNS = 5  # they differ by a percent; the largest counts


def counted(program):
    """Triangles, bytes a triangle, the same while the start is built."""
    told = printed(program, "Memory.a_rock_takes_at_most_250_bytes_a_triangle")
    return found(r"(\d+) triangles: (\d+) bytes a triangle, (\d+) at most", told)


def main():
    program = build_folder(__doc__) / "verification/simulation/verify_memory"
    numbers = max(counted(program) for _ in range(RUNS))
    write_csv(HERE / "memory.csv", ["triangles", "bytes a triangle after 100 steps", "at most while the start is built"],
              [f"{n:.0f}" for n in numbers])


if __name__ == "__main__":
    main()
