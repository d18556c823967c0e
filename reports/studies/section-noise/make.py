"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"noise.csv": "Steady drilling, `cases/standard-workload.toml` (1.0 mm edges, 1 ms, second revolution, 40 faces).",
          "plane.csv": "Volume of a revolution by sections over that of the radial plane, less 1, of ever finer edges."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
