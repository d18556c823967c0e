"""records.py: writes records/*.csv from data/, and records/floors.csv, the differences between repeated measurements.

    /usr/bin/python3 validation/records.py           # writes them
    /usr/bin/python3 validation/records.py --check   # exit code 1 if one is missing or out of date
"""

import csv
import io
import sys
import tomllib
from pathlib import Path

import bit_rows
import cutter_rows
import zijsling

HERE = Path(__file__).resolve().parent


def data_rows(name):
    """Returns the rows of data/NAME/rows.csv as {column: text}."""
    with (HERE / "data" / name / "rows.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def csv_text(rows):
    """Returns rows {column: value} as the text of a csv file."""
    out = io.StringIO()
    writer = csv.DictWriter(out, rows[0], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()


def texts():
    """Returns {file name: text} of all files in records/."""
    cutters, bits = data_rows("single-cutters"), data_rows("full-bits")
    model = tomllib.loads((HERE / "data/zijsling-1987/model.toml").read_text(encoding="utf-8"))
    made = {"single-cutters.csv": cutter_rows.records(cutters),
            "single-cutters-per-strength.csv": cutter_rows.per_strength(cutter_rows.records(cutters)),
            "full-bits.csv": bit_rows.records(bits),
            "zijsling-1987.csv": zijsling.records(model["numbers"]),
            "floors.csv": cutter_rows.floors(cutters) + bit_rows.floors(bits)}
    return {name: csv_text(rows) for name, rows in made.items()}


def stale(folder):
    """Names of the files in a folder that are missing or differ from those made from data/."""
    return [name for name, text in texts().items()
            if not (folder / name).is_file() or (folder / name).read_text(encoding="utf-8") != text]


def main(arguments):
    folder = HERE / "records"
    if arguments == ["--check"]:
        for name in (names := stale(folder)):
            print(f"records/{name} is not what data/ gives: run /usr/bin/python3 validation/records.py")
        return 1 if names else 0
    if arguments:
        print(f"records.py: found {' '.join(arguments)!r}, expected nothing or --check", file=sys.stderr)
        return 2
    folder.mkdir(exist_ok=True)
    for name, text in texts().items():
        (folder / name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
