#!/usr/bin/env python3
"""make.py OUT: the table of this study, from speeds.csv."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from study_tools import markdown_table, read_rows  # noqa: E402

STEPS = (4.0, 2.0, 1.0)  # ms
HEADINGS = ["memory (ms)", "mean at steps of 4 / 2 / 1 ms", "standard deviation at 1 ms", "largest change in a step at 4 / 2 / 1 ms"]


def row_of(found, memory):
    def over_steps(column, digits):
        return " / ".join(f"{found[memory, step][column]:.{digits}f}" for step in STEPS)
    deviation = found[memory, STEPS[-1]]["standard deviation"]
    return [f"{memory:.0f}", over_steps("mean speed", 4), f"{deviation:.3f}", over_steps("largest change in a step", 3)]


def main(out):
    found = {(row["memory, ms"], row["step, ms"]): row for row in read_rows(HERE / "speeds.csv")}
    out.mkdir(parents=True, exist_ok=True)
    table = markdown_table(HEADINGS, [row_of(found, memory) for memory in dict.fromkeys(memory for memory, _ in found)])
    (out / "table.md").write_text(table, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
