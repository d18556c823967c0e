"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"surface.csv": "The surface error after a revolution.",
          "revolutions.csv": "Volume of revolutions 2, 3 and 4 over the exact volume, less 1.",
          "orders.csv": "Orders against the exact boolean by least squares over five levels of edges, 0.13 to 0.008 m."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
