"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {
    "cost.csv": "The page in headless Chromium, without a graphics card.",
    "agreement.csv": "Shipped cases at edges of 3 mm, one revolution or 0.5 s, in both programs: how far they are apart, and processor time of both whole programs.",
    "sensitivity.csv": "The command line alone: the same case with the last digit of its weight changed.",
}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
