#!/usr/bin/env python3
"""make.py OUT: the table of this study, from orders.csv."""

import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table, read_rows  # noqa: E402


def orders_by_case():
    """{case: observed orders}, of the windows in which the bit keeps contact."""
    found = {}
    for row in read_rows(HERE / "orders.csv"):
        if not math.isnan(row["observed order"]):
            found.setdefault(row["case"], []).append(row["observed order"])
    return found


def main(out):
    out.mkdir(parents=True, exist_ok=True)
    rows = [[case, len(orders), f"{min(orders):.2f}", f"{max(orders):.2f}"] for case, orders in orders_by_case().items()]
    (out / "table.md").write_text(markdown_table(["case", "windows", "least order", "greatest order"], rows), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
