"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"differences.csv": "Both settings, and the change that finer edges make.",
          "rounding.csv": "What a millionth of the edge length does where forces move the bit.",
          "owners.csv": "Which kind of part has the removed volume."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
