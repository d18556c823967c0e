"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"steps.csv": "One step of 0.01 s: CPU time, medians of seven interleaved repetitions of one run.",
          "work.csv": "The slow top at t = 10 s: torque evaluations (us) to reach an error of the attitude; the last columns at 1e-6."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
