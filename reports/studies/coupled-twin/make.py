"""make.py OUT: the table of this study, from its CSV file."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"coupled-twin.csv": "The coupled run and its twins; SI units."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
