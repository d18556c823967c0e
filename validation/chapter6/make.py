#!/usr/bin/python3
"""Makes the counterparts of the tables and figures of chapter 6 and appendix D from the synthetic laboratory.

    validation/chapter6/make.py TDBD OUT [--draws N] [--quick] [--record]

Writes OUT/tables/NAME.csv and NAME.md, OUT/figures/NAME.png and OUT/chapter6.json, which lists them
with their captions. Cut runs are kept in OUT/cuts. If the program fails, prints a message and exits
with code 1.
"""

import argparse
import csv
import json
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "blind"), str(HERE.parents[1] / "reports")]

import blind  # noqa: E402
import lab_runs  # noqa: E402
import lab_tables  # noqa: E402
from study_tools import markdown_table  # noqa: E402

DPI = 200
# The order of the thesis, followed by additional ones. A table and a figure with the same name are shown together.
ORDER = ("sample-record", "starts", "fit-bc", "coefficients-combined", "prediction-a", "fit-bc-separate", "coefficients-separate",
         "prediction-a-separate", "objectives", "coefficients-ac", "fit-ac", "coefficients-ab", "fit-ab", "prediction-b", "prediction-c",
         "identified", "thin-cut", "two-laws", "blind")
COARSE = ("rock.edge_length=3 mm", "time.revolutions=2", "time.steps_per_revolution=100")  # --quick


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", type=Path, metavar="TDBD", help="the program")
    parser.add_argument("out", type=Path, metavar="OUT", help="folder of what is made")
    parser.add_argument("--draws", type=int, default=blind.DRAWS, help="of the noise in the blind test (%(default)s)")
    parser.add_argument("--workers", type=int, default=2, help="calls of the program at a time (%(default)s)")
    parser.add_argument("--quick", action="store_true", help="coarse cut runs, a draw, no figures: for tests")
    parser.add_argument("--record", action="store_true", help="replace validation/chapter6/records.csv")
    return parser.parse_args(arguments)


def write_table(folder, table):
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / f"{table.name}.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([table.headings, *table.rows])
    heading = f"Counterpart of {table.counterpart}: {table.title}" if table.counterpart else table.title
    text = f"## {heading}\n\n{table.caption}\n\n{markdown_table(table.headings, table.rows)}"
    (folder / f"{table.name}.md").write_text(text, encoding="utf-8")


def write_figure(folder, figure):
    folder.mkdir(parents=True, exist_ok=True)
    figure.drawing.savefig(folder / f"{figure.name}.png", dpi=DPI, metadata={"Software": None})


def item(kind, made):
    return {"kind": kind, "name": made.name, "counterpart": made.counterpart, "title": made.title, "caption": made.caption}


def draw(results, records, exact, blind_rows, folder):
    import matplotlib  # imported late because it is slow to load and --quick draws nothing
    matplotlib.use("Agg")
    import lab_figures
    figures = lab_figures.figures(results, lab_runs.read_rows(records), lab_runs.read_rows(exact), blind_rows)
    for figure in figures:
        write_figure(folder, figure)
    return figures


def make(chosen):
    out, started = chosen.out.resolve(), time.monotonic()

    def told(what):
        print(f"{time.monotonic() - started:6.1f} s  {what}", flush=True)
    (out / "chapter6.json").unlink(missing_ok=True)
    program = lab_runs.Program(chosen.program.resolve(), out / "cuts", COARSE if chosen.quick else (), chosen.workers)
    records, exact = lab_runs.make_records(program, out, chosen.record)
    told("records of the synthetic laboratory")
    results = lab_runs.calibrate_all(program, out, records)
    told(f"{len(results)} calibrations")
    blind_rows = blind.run(program, out / "blind", 1 if chosen.quick else chosen.draws)
    told("blind test")
    tables = lab_tables.tables(results, blind_rows)
    for table in tables:
        write_table(out / "tables", table)
    figures = [] if chosen.quick else draw(results, records, exact, blind_rows, out / "figures")
    items = [item("table", t) for t in tables] + [item("figure", f) for f in figures]
    items.sort(key=lambda i: ORDER.index(i["name"]))
    (out / "chapter6.json").write_text(json.dumps(items, indent=1) + "\n", encoding="utf-8")
    told(f"{len(tables)} tables, {len(figures)} figures in {out}")


def main(arguments):
    try:
        make(parse(arguments))
    except (lab_runs.Failure, OSError) as error:
        print(f"chapter6: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
