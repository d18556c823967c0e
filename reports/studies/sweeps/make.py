"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {
    "effects.csv": "What back rake, rate of penetration and rotary speed explain of bit B's figures: 64 runs, each alone and their mean.",
    "balance.csv": "Bit B before and after: 512 places of its blades by the planar model, 24 drilled.",
    "cost.csv": "What a sweep costs: 64 points of one revolution of bit B, edges of 4 mm.",
}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
