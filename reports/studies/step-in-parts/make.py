"""make.py OUT: the tables of this study, from its CSV files."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from csv_tables import write_tables  # noqa: E402

TABLES = {"lists.csv": "Near lists and one classification of touched triangles: least of the runs' medians (their median).",
          "parts.csv": "The same change by parts of a step of the standard workload at 1.0 mm (10th percentile of 500 steps, timers included).",
          "one_scan.csv": "One scan for sweeping and touching, later and on a quieter machine: least of the runs' medians (their median).",
          "phases_before.csv": "Instructions by phase, counted, before stars and deferred maintenance.",
          "phases.csv": "The same after."}

if __name__ == "__main__":
    write_tables(HERE, TABLES, sys.argv[1])
