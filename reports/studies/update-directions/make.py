"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"rules.csv": "Bit B with each rule for the update direction.",
          "meshes.csv": "Bits B and R with each rule, edges of 3 mm."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
