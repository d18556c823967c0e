"""comparison_costs.py RESULTS: writes comparison_costs.csv, the processor time of each model in each run of the comparison, from the timing.json
of the runs below RESULTS (results/report/comparison/data).

It is measured once and committed, so that the page has the same bytes whenever it is made. Measure again when a run or a model changes, on a
quiet machine.
"""

import csv
import json
import sys
from pathlib import Path

from fingerprint import Stale

HERE = Path(__file__).parent
NAME = "comparison_costs.csv"
HEADS = ("run", "model", "cpu_s", "simulated_s")


def measured(results):
    """Rows of all runs below a folder."""
    rows = []
    for file in sorted(Path(results).rglob("timing.json")):
        models = json.loads(file.read_text(encoding="utf-8"))["models"]
        rows += [(file.parent.relative_to(results).as_posix(), model, t["cpu_s"], t["simulated_s"]) for model, t in models.items()]
    return rows


def write(path, rows):
    with Path(path).open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(HEADS)
        table.writerows(rows)


def read(path):
    """{run: {model: CPU seconds a simulated second, None of a model without time}}; nothing of a file that is not there. Raises Stale of a line
    that is none of these."""
    costs = {}
    if not Path(path).is_file():
        return costs
    with Path(path).open(newline="", encoding="utf-8") as file:
        for number, row in enumerate(csv.reader(file), 1):
            if number == 1 and tuple(row) == HEADS:
                continue
            try:
                run, model, cpu, simulated = row[0], row[1], *map(float, row[2:])
            except (ValueError, IndexError):
                raise Stale(f"{path}:{number}: found {','.join(row)!r}, expected {','.join(HEADS)}") from None
            costs.setdefault(run, {})[model] = cpu / simulated if simulated else None
    return costs


def of_run(costs, run, path):
    """Those of a run. Raises Stale when it was never measured."""
    if run not in costs:
        raise Stale(f"{path}: found no processor time of the run {run}, expected that of each model: python3 reports/{Path(__file__).name} "
                    "results/report/comparison/data writes it")
    return costs[run]


if __name__ == "__main__":
    write(HERE / NAME, measured(sys.argv[1]))
