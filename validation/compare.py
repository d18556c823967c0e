"""compare.py RESULTS: computes one row for each comparison of split.toml and law, from the result folders in RESULTS.

Writes comparisons.csv, comparisons.md and a figure per comparison to RESULTS. Exit code 1 if a
verdict differs from the one in split.toml, because the sentence "why" there then explains another
result."""

import argparse
import csv
import sys
from pathlib import Path

import comparison
import figures
import pressures

COLUMNS = ("name", "kind", "law", "load", "n", "mean_error", "mean_floor", "rms_error", "rms_floor", "inside_interval", "extrapolates",
           "verdict", "why")


def rows(compared):
    """Returns a row for each load of a comparison. The verdict is that of all its loads together."""
    return [dict(zip(COLUMNS, (compared.name, compared.kind, compared.law, load.name, len(load.predicted),
                               f"{load.mean():.4f}", f"{load.floor.mean:.4f}", f"{load.rms():.4f}", f"{load.floor.rms:.4f}",
                               f"{sum(load.inside) / len(load.inside):.3f}", "yes" if compared.extrapolates else "no",
                               compared.verdict(), compared.why))) for load in compared.loads]


def write_csv(path, compared):
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for c in compared:
            writer.writerows(rows(c))


def percent(values, form="{:+.0f}"):
    return " / ".join(form.format(100.0 * v) for v in values)


def markdown(compared):
    """Returns one table per comparison as Markdown."""
    lines = []
    for name in dict.fromkeys(c.name for c in compared):
        group = [c for c in compared if c.name == name]
        first = group[0]
        loads = " / ".join(load.name for load in first.loads)
        lines += [f"## {first.title}", "", f"{first.kind}, {len(first.loads[0].predicted)} records of {loads}; floor: mean "
                  f"{percent((load.floor.mean for load in first.loads), '{:.0f}')} %, rms "
                  f"{percent((load.floor.rms for load in first.loads), '{:.0f}')} %: {first.floor_of}", "",
                  "| law | mean error % | rms error % | inside the interval | verdict | why |", "|---|---|---|---|---|---|"]
        lines += [f"| {c.law} | {percent(load.mean() for load in c.loads)} | "
                  f"{percent((load.rms() for load in c.loads), '{:.0f}')} | {100 * c.inside():.0f} % | "
                  f"{c.verdict()} | {c.why} |" for c in group]
        lines.append("")
    return "\n".join(lines)


def short_table(compared):
    """Returns the table that is printed."""
    lines = [f"{'comparison':24} {'law':36} {'kind':21} {'mean %':>9} {'floor':>6} {'rms %':>8} {'floor':>7}  verdict"]
    for c in compared:
        lines.append(f"{c.name:24} {c.law:36} {c.kind:21} {percent(x.mean() for x in c.loads):>9} "
                     f"{percent((x.floor.mean for x in c.loads), '{:.0f}'):>6} "
                     f"{percent((x.rms() for x in c.loads), '{:.0f}'):>8} "
                     f"{percent((x.floor.rms for x in c.loads), '{:.0f}'):>7}  {c.verdict()}")
    return "\n".join(lines)


def surprises(compared):
    return [f"{c.name} by {c.law}: found '{c.verdict()}', split.toml expects '{c.expected}': read its 'why' again"
            for c in compared if c.verdict() != c.expected]


def compare(results, split=None):
    """Reads the results, writes tables and figures, and returns the comparisons."""
    split = comparison.read_split() if split is None else split
    compared = comparison.read_all(split, results, comparison.floors())
    write_csv(results / "comparisons.csv", compared)
    (results / "comparisons.md").write_text(markdown(compared), encoding="utf-8")
    figures.draw_all(results, compared)
    pressures.draw_all(results, split)
    return compared


def report(compared):
    """Prints the table and unexpected verdicts, and returns the exit code."""
    print(short_table(compared))
    found = surprises(compared)
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    try:
        return report(compare(parser.parse_args().results))
    except comparison.Problem as problem:
        print(f"compare: {problem}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
