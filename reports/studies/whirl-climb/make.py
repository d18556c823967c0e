"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"climb.csv": "Means of the second half of one second, by string.",
          "steps.csv": "Advance of the same time over the time step.",
          "steps-before.csv": "The same before forces and resistances were one flow."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
