"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {
    "cost.csv": "Processor time of a run: the whole command line; reading and running a case in Python; importing the package.",
    "instructions.csv": "Million instructions of a step, before and after the rooms were compiled for a shared library.",
}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
