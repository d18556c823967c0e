"""The numbers of README.md, from the data of this study."""

import re
from pathlib import Path

from study_tools import read_csv

HERE = Path(__file__).parent
ASKED = {"standard, 1.0 mm": 220.0, "standard, 0.7 mm": 360.0}  # us
GIVEN = ["is divided into 64 sectors", "count 100 steps after a revolution", "took turns of 100 steps", "the standard workload at 1.0 mm went", "was then 0.22 ms at 1.0 mm edges and 0.36 ms at 0.7 mm",
         "Runs at 0.7 mm differ", "in 21 of 58 cases a step, and now do in 4", "24 shipped cases, shortened, at 1 and 2 mm", "a section cost 1.09 times the instructions",
         "ran 1.59 times as fast on two threads in the first three workloads, and 1.52, 1.42 and 1.51 times before"]


def missed_by():
    """Least of the runs' medians over what was asked."""
    lists = read_csv(HERE / "lists.csv")
    after = {name: float(cell.split()[0]) for name, cell in zip(lists["us a step"], lists["after"])}
    return [after[name] / asked for name, asked in ASKED.items()]


def million_instructions(file, workload):
    return 1e-3 * sum(read_csv(HERE / file)[workload])


def parts():
    """{part: (us of all that it says, how many a step)}, after near lists."""
    table = read_csv(HERE / "parts.csv")
    us = [sum(map(float, re.findall(r"\d+", str(cell)))) for cell in table["after, us"]]
    return dict(zip(table["part of a step"], zip(us, table["how many a step"])))


def of_parts():
    of = parts()
    [bisections] = re.findall(r"(\d+) bisections", of["maintenance, a fifth of one"][1])
    yield "maintenance bisects {:.0f} edges", int(bisections)
    kernel = ("candidates: index, lists, hull", "directions, paths, planes", "exits and moves", "volumes")
    yield "find, test, move and volumes do, {:.0f} us", sum(of[part][0] for part in kernel)
    around, how_many = of["sections: around them"]
    [corners] = re.findall(r"(\d+) corners", how_many)
    yield "({:.0f} ns a corner, {:.0f} corners around sections)", 1e3 * around / int(corners), int(corners)


def stated():
    yield "by a factor of {:.1f} and {:.1f} on the machine", *missed_by()
    yield ("went from {:.2f} to {:.2f} million instructions, one of `drill-bit-b` from {:.2f} to {:.2f}",
           *[million_instructions(f, w) for w in ("standard-1.0", "drill-bit-b") for f in ("phases_before.csv", "phases.csv")])
    yield from of_parts()
