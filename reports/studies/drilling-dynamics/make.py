#!/usr/bin/env python3
"""Writes table.md from data.csv into the folder given."""
import csv
import sys
from pathlib import Path

with open(Path(__file__).parent / "data.csv", newline="") as file:
    head, *rows = list(csv.reader(file))
lines = [head, ["---"] * len(head), *rows]
text = "".join("| " + " | ".join(line) + " |\n" for line in lines)
(Path(sys.argv[1]) / "table.md").write_text(text)
