"""Tables of benchmarks/README.md from what rivals, count.py, metre and tests measured: goals, and our step over a height field's."""

import json
import math
import pathlib

GOALS = pathlib.Path(__file__).resolve().parent / "goals.json"


def find(data, path):
    """The figure at a path of keys; a list is searched for the row that has the key as name or surface. None where nothing is."""
    for key in path:
        if isinstance(data, list):
            data = next((row for row in data if key in (row.get("name"), row.get("surface"))), None)
        elif isinstance(data, dict):
            data = data.get(key)
        if data is None:
            return None
    return data


def figures(measured):
    """All that goals read: conditions of rivals and rows of tables by name."""
    runs = ("rivals", "rivals_2_threads")
    return measured | {run: {c["name"]: c["rows"] for c in measured.get(run, {}).get("conditions", [])} for run in runs}


def told(value):
    return "not measured" if value is None else f"{value:.3g}"


def verdict(value, limit, is_least):
    """Met, or missed by how much."""
    if value is None or limit is None:
        return ""
    over = limit / value if is_least else value / limit
    return "met" if over <= 1.0 else f"missed by {math.ceil(100 * over - 100)} %"


def goal_row(goal, all_figures, before):
    value = find(all_figures, goal["read"])
    if "over" in goal:  # a ratio to an earlier figure
        base = find(all_figures, goal["over"])
        value = value / base if value is not None and base else None
    is_least = "at_least" in goal
    limit = goal.get("at_least", goal.get("at_most"))
    if "at_most_of" in goal:
        limit = find(all_figures, goal["at_most_of"])
    asked = "stated" if limit is None else f"at {'least' if is_least else 'most'} {limit:.3g}"
    was = None if "over" in goal else find(before, goal["read"])
    return f"| {goal['goal']} | {asked} | {told(value)} | {'' if was is None else told(was)} | {verdict(value, limit, is_least)} |\n"


THREADS_ASKED = 1.65
THREADS_WORKLOADS = {"standard-1.0": "1.0 mm", "standard-0.7": "0.7 mm", "drill-bit-b": "`drill-bit-b`", "drill-bit-r": "`drill-bit-r`",
                     "drill-bit-b-whirl": "`drill-bit-b-whirl`"}


def speedup(all_figures, workload):
    """Mean wall time of a step on two threads, under that on one thread: CPU time there, of a program that does nothing else."""
    one, two = (find(all_figures, [key, "warm", workload, "mean_us"]) for key in ("rivals", "rivals_2_threads"))
    return one / two if one and two else None


def threads_row(workload, now, before):
    value, was = speedup(now, workload), speedup(before, workload)
    return (f"| two threads: speed-up over one thread, {THREADS_WORKLOADS[workload]} | at least {THREADS_ASKED} | {told(value)} "
            f"| {'' if was is None else told(was)} | {verdict(value, THREADS_ASKED, True)} |\n")


def goals_table(measured):
    now, before = figures(measured), figures(measured.get("before", {}))
    head = "| quantity | goal | measured | before | |\n|---|---|---|---|---|\n"
    rows = [goal_row(g, now, before) for g in json.loads(GOALS.read_text(encoding="utf-8"))]
    return head + "".join(rows) + "".join(threads_row(w, now, before) for w in THREADS_WORKLOADS)


def instructions_of(row, counted):
    """By the processor's counters, else by valgrind."""
    own = row.get("million_instructions")
    return own if own is not None else counted.get(row["name"])


def number(value, digits=2):
    return "-" if value is None else f"{value:.{digits}f}"


def rivals_table(measured):
    """One line for each side: means and 99th percentiles over the height field's mean, warm and cold; medians beside them."""
    conditions = figures(measured)["rivals"]
    cold = {row["name"]: row for row in conditions.get("cold", [])}
    two = {row["name"]: row for row in figures(measured)["rivals_2_threads"].get("warm", [])}
    counted = measured.get("million_instructions", {})
    text = ("| a step of | mean, us | mean over z-map | 99th percentile | median, us | cold: mean over z-map | two threads: mean, us | M instructions | M cycles |\n"
            "|---|---|---|---|---|---|---|---|---|\n")
    for row in conditions.get("warm", []):
        other = cold.get(row["name"], {})
        two_us = two.get(row["name"], {}).get("mean_us") if "triangles" in row else None
        cells = [row["what"], number(row["mean_us"], 0), number(row["mean_over_z_map"]), number(row["p99_over_z_map"]), number(row["us"], 0),
                 number(other.get("mean_over_z_map")), number(two_us, 0), number(instructions_of(row, counted)), number(row.get("million_cycles"))]
        text += "| " + " | ".join(cells) + " |\n"
    return text
