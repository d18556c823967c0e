"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"cutters.csv": "Bit B after 100 m: flats and temperatures of TDBD and of Glowka's model.",
          "convergence.csv": "Worn volume of the case wear-bit-b over edges, steps, wear steps and acceleration."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
