"""Reads and writes the data of studies: CSV files, Markdown tables, and values of benchmarks/measured.json."""

import csv
import json
import math
import sys
from pathlib import Path

REPORTS = Path(__file__).resolve().parent
ROOT = REPORTS.parent


class Table(list):
    """The rows of a CSV file, {column: value} each. `table["x"]` is a column, `table[0]` a row."""

    def __getitem__(self, key):
        return [row[key] for row in self] if isinstance(key, str) else super().__getitem__(key)

    @property
    def columns(self):
        """{column: values}."""
        return {name: self[name] for name in self[0]} if self else {}

    def where(self, *pairs):
        """The rows with these values: where("wall", "rock", "edges, mm", 1.5)."""
        wanted = list(zip(pairs[::2], pairs[1::2], strict=True))
        return Table(row for row in self if all(row[name] == value for name, value in wanted))

    def row(self, *pairs):
        """The only row with these values. Raises KeyError if there is not exactly one."""
        found = self.where(*pairs)
        if len(found) != 1:
            raise KeyError(f"found {len(found)} rows with {pairs}, expected 1")
        return found[0]

    def by(self, *names):
        """{value of a column: row}, or {(values of several columns): row}. A later row replaces an earlier one."""
        return {row[names[0]] if len(names) == 1 else tuple(row[n] for n in names): row for row in self}


def numbers(words):
    try:
        return [float(w) for w in words]
    except ValueError:
        return words


def read_rows(path):
    """Reads a CSV file with a line of headings. A column contains numbers if all its values are numbers, otherwise text."""
    headings, *rows = read_text(path)
    columns = {h: numbers([row[i] for row in rows]) for i, h in enumerate(headings)}
    return Table(dict(zip(columns, values, strict=True)) for values in zip(*columns.values(), strict=True))


def read_text(path):
    """The lines of a CSV file as lists of words."""
    with Path(path).open(newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def write_rows(path, rows):
    """Writes dictionaries as a CSV file with a line of headings. A key that a row lacks is left empty."""
    rows = list(rows)
    headings = dict.fromkeys(key for row in rows for key in row)
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, headings, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def markdown_table(headings, rows):
    """The rows under their headings, as Markdown."""
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def order(sizes, errors):
    """The observed order: the slope of log(error) over log(size), by least squares."""
    x, y = [math.log(s) for s in sizes], [math.log(e) for e in errors]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def percent(ratio):
    """By how much a ratio differs from 1, without its sign."""
    return 100.0 * abs(ratio - 1.0)


def benchmark_data():
    return json.loads((ROOT / "benchmarks/measured.json").read_text(encoding="utf-8"))


def measured(*path):
    """The value at a path of keys of benchmarks/goals.json. "before" as the first key selects the older commit.
    Raises KeyError if there is no such value."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    try:
        from goals import figures, find
    finally:
        sys.path.remove(str(ROOT / "benchmarks"))
    data = benchmark_data()
    of, path = (data["before"], path[1:]) if path[0] == "before" else (data, path)
    number = find(figures(of), path)
    if number is None:
        raise KeyError(f"benchmarks/measured.json has nothing at {' '.join(path)}")
    return number
