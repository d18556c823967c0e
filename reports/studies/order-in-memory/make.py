"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {
    "times.csv": "A step after renumbering over the same step before.",
    "renumbering.csv": "One renumbering, after as many revolutions without any.",
    "long-runs.csv": "A run with renumberings over one without, in turn.",
}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
