"""make.py OUT: the table of this study, from data.csv."""

import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main(out):
    with open(HERE / "data.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    lines = ["| `update.gage_teeth` | vertices move | worst quality |", "|---|---|---|"]
    lines += [f"| {r['rule']} | {r['motion']} | {r['worst_quality']} |" for r in rows]
    out.mkdir(parents=True, exist_ok=True)
    (out / "table.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
