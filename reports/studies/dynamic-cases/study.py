"""Convergence of every shipped dynamic case: `tdbd converge` over five time steps and four edge lengths.

before.csv has the same levels by the program of commit 7b1ef44f, before forces and resistances were one flow. The script that
measured it with that program and its cases is reports/studies/dynamic-cases/before.py of commit d75856f9.
"""

import json
import math
import re
import tomllib
from pathlib import Path

from study_tools import ROOT, markdown_table, read_rows

HERE = Path(__file__).resolve().parent
CASES = ["drill-bit-b", "drill-bit-b-whirl", "drill-bit-b-whirl-rock", "drill-bit-r", "stick-slip", "bit-bounce", "high-frequency",
         "high-frequency-beds", "laboratory"]
QUANTITIES = ["wob_mean", "tob_mean", "rop_mean", "rotary_speed_mean", "cone_speed_ratios", "torsional_frequency", "axial_frequency",
              "stick_slip_severity", "wob_swing", "orbit_radius", "orbit_frequency"]
# The fields of a study that a run reads (src/simulation/case).
READ = ["wob_mean", "tob_mean", "rop_mean", "rotary_speed_mean", "stick_slip_severity", "torsional_frequency", "orbit_radius", "orbit_frequency"]
SAMPLING = {"wob_mean": "wob_mean_n", "tob_mean": "tob_mean_n_m", "rop_mean": "rop_mean_m_per_s", "rotary_speed_mean": "rotary_speed_mean_rad_per_s"}
STUDIES = {"step": ("time.step", 5, 2.0), "edge": ("rock.edge_length", 4, 2.0**0.5)}  # key, levels, factor
ABOVE = 2.0  # the coarsest level over the shipped value, where such a step is stable
ALONE = {"output.energy_order": "off", "output.convergence": ""}

# Tables.

HEADINGS = ["case", "quantity", "shipped", "by step", "order", "by edges", "order", "by sampling"]
SHOWN = ["wob_mean", "tob_mean", "rop_mean", "rotary_speed_mean", "cone_speed_ratios", "torsional_frequency", "stick_slip_severity",
         "orbit_radius", "orbit_frequency"]
# Rates of the current program are displacements over time.
COMPARED = ["case", "program", "weight, kN", "torque, N m", "rate, mm/s", "`rop_mean` then, mm/s", "rotary speed, rad/s"]
THEN = [("wob_mean", 1e-3), ("tob_mean", 1.0), ("advance", 1e3), ("rop_mean", 1e3), ("rotary_speed_mean", 1.0)]
NOW = [("wob_mean", 1e-3), ("tob_mean", 1.0), ("rop_mean", 1e3), ("none", 1.0), ("rotary_speed_mean", 1.0)]
CAPTION = """
The program of commit 7b1ef44f (2026-11-27), before forces and resistances became one flow, on its shipped cases and the same
levels. Rates are displacements over time; `rop_mean` is what that program reported. In brackets: changes to the finest step
and to the finest edges, per cent.

"""


def observed(row, which):
    """The observed order, or in brackets the slope of differences that have not settled on an order."""
    if row[f"order_{which}"]:
        return f"{float(row[f'order_{which}']):.1f}"
    slope = row[f"slope_{which}"]
    return f"({float(slope):.1f})" if slope else "-"


def line_of_case(r):
    sampling = r["uncertainty_sampling"]
    return [r["case"], f"{r['quantity']}, {r['unit']}", f"{float(r['value']):.5g}", f"{float(r['uncertainty_step']):.2g}", observed(r, "step"),
            f"{float(r['uncertainty_edge']):.2g}", observed(r, "edge"), f"{float(sampling):.2g}" if sampling else ""]


def digits(x):
    """Two digits; a change above 100 per cent is not given in more detail."""
    return ">100" if x > 100.0 else f"{x:.2g}"


def line_of(found, case, program, columns):
    """Shipped values (to the finest step / to the finest edges, per cent)."""
    cells = []
    for quantity, scale in columns:
        row = found.get((case, quantity))
        value = float(row["value"]) if row else math.nan
        changes = [digits(100.0 * abs(float(str(row[key]).split()[-1]) / value - 1.0)) for key in ("by_step", "by_edge")] if row else []
        cells.append(f"{scale * value:.4g} ({' / '.join(changes)})" if row else "")
    return [case, program, *cells]


def tables():
    rows, before = (read_rows(HERE / name) for name in ("cases.csv", "before.csv"))
    now, then = (table.by("case", "quantity") for table in (rows, before))
    lines = []
    for case in dict.fromkeys(r["case"].partition(",")[0] for r in before):
        labels = dict.fromkeys(r["case"] for r in before if r["case"].partition(",")[0] == case)
        lines += [line_of(then, label, "before", THEN) for label in labels] + [line_of(now, case, "now", NOW)]
    return markdown_table(HEADINGS, map(line_of_case, (r for r in rows if r["quantity"] in SHOWN))) + CAPTION + markdown_table(COMPARED, lines)


def draw_rates(axes, which):
    """Rates of penetration over levels, divided by that of the finest level. The bouncing bit hardly advances and is omitted."""
    from figures import style
    colours = (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.GOLD, style.SKY, style.BLACK, style.GREY, "#7f5f3f")
    rows = [r for r in read_rows(HERE / "cases.csv") if r["quantity"] == "rop_mean" and r["case"] != "bit-bounce"]
    for row, colour in zip(rows, colours):
        sizes, values = (list(map(float, str(row[key]).split())) for key in (f"{which}s", f"by_{which}"))
        axes.plot([1e3 * s for s in sizes], [v / values[-1] for v in values], "o-", color=colour, label=row["case"])


# Measurement.


def si(quantity):
    """A length or a time of a case file."""
    if not isinstance(quantity, str):
        return float(quantity)
    number, unit = re.fullmatch(r"([0-9.e+-]+) *([a-z]+)", quantity).groups()
    return float(number) * {"ms": 1e-3, "s": 1.0, "mm": 1e-3, "m": 1.0}[unit]


def converge(m, name, which):
    """The study of one case over one key, starting at its coarsest level, and the index of the shipped level."""
    key, levels, factor = STUDIES[which]
    section, entry = key.split(".")
    own = si(tomllib.loads((ROOT / f"cases/{name}.toml").read_text(encoding="utf-8"))[section][entry])
    start = ABOVE * own if m.is_valid(f"cases/{name}.toml", {key: ABOVE * own}) else own
    run = m.run(f"cases/{name}.toml", {key: start, **ALONE}, "converge", ["--over", key, "--levels", str(levels), "--factor", repr(factor)])
    result = json.loads((run.folder / "convergence.json").read_text(encoding="utf-8"))
    sizes = [level["size"] for level in result["levels"]]
    return result, min(range(len(sizes)), key=lambda i: abs(sizes[i] - own))


def values(result, quantity):
    """One number per level: the mean over cones."""
    found = [level["state"].get(quantity) for level in result["levels"]]
    return [sum(v) / len(v) for v in found] if all(found) else None


def write_for_runs(name, results):
    """cases/convergence/NAME.json: the studies of a case, with the fields that its runs read."""
    short = [{"keys": result["keys"],
              "levels": [{"sizes": level["sizes"], "state": {q: level["state"][q] for q in READ if q in level["state"]}} for level in result["levels"]],
              "variables": {q: {"uncertainty": {"value": result["variables"][q]["uncertainty"]["value"]}} for q in READ if q in result["variables"]}}
             for result in results]
    (ROOT / f"cases/convergence/{name}.json").write_text(json.dumps(short, indent=1) + "\n", encoding="utf-8")


def rows_of(m, name):
    found = {which: converge(m, name, which) for which in STUDIES}
    sampling = m.run(f"cases/{name}.toml", ALONE).summary["uncertainty"]
    write_for_runs(name, [result for result, _ in found.values()])
    for quantity in QUANTITIES:
        if values(found["step"][0], quantity) is None:
            continue
        row = {"case": name, "quantity": quantity}
        for which, (result, at) in found.items():
            of_levels, variable = values(result, quantity), result["variables"][quantity]
            row["unit"], row["value"] = variable["units"], of_levels[at]
            row[f"{which}s"] = " ".join(f"{level['size']:.6g}" for level in result["levels"])
            row[f"by_{which}"] = " ".join(f"{v:.6g}" for v in of_levels)
            row[f"order_{which}"] = variable["order"] if variable["order"] is not None else ""
            row[f"slope_{which}"] = variable["order_of_all"]
            # The change to the finest level, and the uncertainty of that level.
            row[f"uncertainty_{which}"] = abs(of_levels[at] - of_levels[-1]) + variable["uncertainty"]["value"]
        row["uncertainty_sampling"] = sampling[SAMPLING[quantity]] if quantity in SAMPLING else ""
        yield row


def measure(m):
    """Parts for --only: names of cases. Rows of other cases are kept."""
    chosen = [name for name in CASES if m.includes(name)]
    m.replace("cases.csv", [r for name in chosen for r in rows_of(m, name)], "case", CASES)
