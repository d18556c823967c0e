"""Records of single cutters from data/single-cutters, and the scatter of their repeats."""

import math
from collections import defaultdict

# The series of data that are used, by the beginning of their names: cutter, rock. Texas granite: source.toml.
SERIES = {"J BSS": ("j", "berea-sandstone"), "K BSS": ("k", "berea-sandstone"),
          "J SWG": ("j", "sierra-white-granite"), "D SWG": ("d", "sierra-white-granite")}
STRENGTH_PSI = {"berea-sandstone": 7100.0, "sierra-white-granite": 21500.0}  # as stated with the rows
SPEED_IN_S = 2.1
SHALLOW_IN = 0.03  # cuts of the blunt cutter: shallower ones are fitted, deeper ones predicted
LOADS = {"normal": "Fn_lbf", "drag": "Fd_lbf"}


def series_of(row):
    """Returns (cutter, rock) of a row of the data, or None if it is not used."""
    return next((s for start, s in SERIES.items() if row["case"].startswith(start)), None)


def tool(row):
    """The cutter's name in records: its rock and, for the blunt cutter, whether it cut shallow or deep."""
    cutter, rock = series_of(row)
    name = f"{cutter}-{rock.split('-')[-1] if 'granite' in rock else 'berea'}"
    if cutter != "d":
        return name
    return name + ("-shallow" if float(row["doc_in"]) < SHALLOW_IN else "-deep")


def records(rows):
    return [{"test": tool(r), "cutter": tool(r), "rock": series_of(r)[1], "speed [in/s]": SPEED_IN_S,
             "depth [in]": r["doc_in"], "normal [lbf]": r["Fn_lbf"], "drag [lbf]": r["Fd_lbf"]}
            for r in rows if series_of(r)]


def per_strength(recorded):
    """The same with forces multiplied by the strength of Berea over that of the rock, and with
    Berea as the rock. A law without strength then predicts one rock from the other in proportion to
    strength."""
    def scaled(record, load):
        return f"{float(record[load]) * STRENGTH_PSI['berea-sandstone'] / STRENGTH_PSI[record['rock']]:.6g}"
    return [record | {"rock": "berea-sandstone", "normal [lbf]": scaled(record, "normal [lbf]"),
                      "drag [lbf]": scaled(record, "drag [lbf]")} for record in recorded]


def repeats(rows):
    """Returns {(cutter, rock, listed depth): rows} for depths that were cut more than once."""
    groups = defaultdict(list)
    for r in filter(series_of, rows):
        groups[(*series_of(r), r["doc_in"])].append(r)
    return {key: group for key, group in groups.items() if len(group) > 1}


def scatter(groups, column):
    """Returns (readings, pooled standard deviation of the logarithm within the groups)."""
    squares = freedom = 0.0
    for group in groups:
        logs = [math.log(float(r[column])) for r in group]
        mean = sum(logs) / len(logs)
        squares += sum((x - mean) ** 2 for x in logs)
        freedom += len(logs) - 1
    return sum(map(len, groups)), math.sqrt(squares / freedom)


def about_own_curve(rows, column):
    """Standard deviation of the logarithm about a power law of the depth that is fitted to the same rows."""
    x = [math.log(float(r["doc_in"])) for r in rows]
    y = [math.log(float(r[column])) for r in rows]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)
    left = sum((b - my - slope * (a - mx)) ** 2 for a, b in zip(x, y))
    return math.sqrt(left / (len(x) - 2))


def floors(rows):
    """Floors for each series and load. The rms is that about a curve through the rows themselves,
    which is smaller than that of any law fitted to other rows. The mean is the scatter of repeats,
    which limits how well any mean is known."""
    found = []
    for cutter, rock in SERIES.values():
        series = [r for r in rows if series_of(r) == (cutter, rock)]
        for load, column in LOADS.items():
            readings, repeated = scatter(repeats(rows).values(), column)
            found.append({"floor": f"{cutter} in {rock}", "load": load, "mean": f"{repeated:.4f}",
                          "rms": f"{about_own_curve(series, column):.4f}",
                          "of": f"mean: scatter of {readings} repeats at one listed depth, all series; "
                                f"rms: {len(series)} rows about a power law of their own"})
    return found
