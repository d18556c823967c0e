"""make.py OUT: the table of this study, from its CSV file."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

if __name__ == "__main__":
    write_tables(HERE, {"executions.csv": "Calls of each reader, the time that they took, and inputs that failed.",
                        "sequences.csv": "Lists of commands on the rock's surface."}, sys.argv[1])
