"""What the scripts of the studies share. A study's make.py finds it in the folder two above its own."""

import csv
from pathlib import Path


def read_csv(path):
    """{column: values} of a CSV file with a line of headings; numbers where all of a column are."""
    with Path(path).open(newline="", encoding="utf-8") as file:
        headings, *rows = csv.reader(file)
    columns = {h: [row[i] for row in rows] for i, h in enumerate(headings)}
    return {h: numbers(values) for h, values in columns.items()}


def read_rows(path):
    """The same as a list of rows, {column: value} each."""
    columns = read_csv(path)
    return [dict(zip(columns, values, strict=True)) for values in zip(*columns.values(), strict=True)]


def write_rows(path, rows):
    """Writes dictionaries with the same keys as a CSV file with a line of headings."""
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def numbers(words):
    try:
        return [float(w) for w in words]
    except ValueError:
        return words


def markdown_table(headings, rows):
    """The rows under their headings, as Markdown."""
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)
