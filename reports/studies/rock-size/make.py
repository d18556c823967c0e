"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"walls.csv": "The same cutting (1.6 mm edges) under ever higher walls.",
          "edges.csv": "Ever finer cutting.",
          "memory.csv": "Memory of the rock, its index and the room that steps keep."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
