"""Tables of a study straight from its CSV files, for a make.py that has nothing to compute."""

import csv
from pathlib import Path


def markdown_table(path):
    """The rows of a CSV file as a Markdown table."""
    with Path(path).open(newline="", encoding="utf-8") as file:
        headings, *rows = csv.reader(file)
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def write_tables(folder, tables, out):
    """Writes OUT/table.md: the tables of a folder, {file: caption}, each below its caption."""
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    parts = [f"{caption}\n\n{markdown_table(Path(folder) / file)}" for file, caption in tables.items()]
    (out / "table.md").write_text("\n".join(parts), encoding="utf-8")
