"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"pairs.csv": "Intersecting pairs of triangles, 2026-11-22.",
          "now.csv": "The same cases with untangling, 2026-11-26.",
          "core.csv": "Pairs in `bit-c-steady` at 60 m/h, four revolutions, 20 looks, 2026-11-26."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
