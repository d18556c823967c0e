"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"sticks.csv": "Stick-slip: the sticks of 6 s.",
          "sticks-before.csv": "The same where every impulse is explicit.",
          "plunges.csv": "The same bit not turned, from 1 s to 3 s.",
          "plunges-before.csv": "The same where every impulse is explicit.",
          "case.csv": "The shipped case of 20 s.",
          "case-before.csv": "The same where every impulse is explicit."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
