"""The table of a sweep (NAME.nc) as columns with labels and units, and what its factors explain: main effects and a linear regression."""

from dataclasses import dataclass, replace

import netCDF4
import numpy as np

BINS = 8  # of a factor with more values than this
WORDS = {"wob": "weight on bit", "tob": "torque on bit", "rop": "rate of penetration"}
# Units in SI, as tables have them and as names of figures end: the unit in pictures, and its value in SI.
DRAWN = {"N": ("kN", 1e3), "N m": ("kN m", 1e3), "m/s": ("m/h", 1.0 / 3600.0), "rad/s": ("rpm", np.pi / 30.0), "Pa": ("MPa", 1e6), "m": ("mm", 1e-3),
         "W": ("kW", 1e3)}
MEANS = ("mean", "std", "min", "max")  # put before the quantity in a label


@dataclass
class Column:
    """A factor or a figure over the points. Texts are numbered in the order of their first appearance."""

    name: str
    label: str
    values: np.ndarray
    words: list  # of a factor of texts; empty: numbers
    unit: str = "1"

    def described(self):
        """The full name with the unit."""
        return self.name if self.unit == "1" else f"{self.name} [{self.unit}]"


@dataclass
class Table:
    title: str
    factors: list
    figures: list
    front: np.ndarray  # True: not dominated; all False without goals
    failed: int
    is_grid: bool  # the design has every combination of the factors' values once
    unsteady: int = 0  # points whose means are not steady
    source: str = ""  # the program


def column_of(variable):
    unit, name = getattr(variable, "units", "1"), variable.name
    if variable.dtype is str:
        words = list(dict.fromkeys(variable[:]))
        return Column(name, name, np.array([float(words.index(w)) for w in variable[:]]), words)
    return Column(name, name, np.ma.filled(variable[:], np.nan).astype(float), [], unit)


def suffix_of(unit):
    """The end of the name of a figure with this unit: "_m_per_s"."""
    return "_" + unit.replace("/", "_per_").replace(" ", "_").lower()


def unit_of(column):
    """The unit of a column; that of a figure without one follows from the end of its name."""
    if column.unit != "1":
        return column.unit
    fitting = [unit for unit in DRAWN if column.name.endswith(suffix_of(unit))]
    return max(fitting, key=len, default="1")


def set_labels(columns):
    """Labels for axes: the last part of the name in words, with the unit. Names with the same last part keep their other parts."""
    last = [c.name.rpartition(".")[2] for c in columns]
    for column, short in zip(columns, last):
        unit = unit_of(column)
        words = (short if last.count(short) == 1 else column.name).removesuffix(suffix_of(unit)).split("_")
        first = [word for word in words if word in MEANS]
        words = " ".join(first + [WORDS.get(word, word) for word in words if word not in MEANS])
        column.label = words if unit == "1" else f"{words} [{DRAWN.get(unit, (unit, 1.0))[0]}]"


def in_drawn_units(column):
    """The column with its values in the unit of its label."""
    factor = DRAWN.get(unit_of(column), ("", 1.0))[1]
    return replace(column, values=column.values / factor) if not column.words else column


def is_grid(factors):
    """Whether the points are all combinations of the factors' values, each once."""
    points = np.array([f.values for f in factors]).T
    count = int(np.prod([np.unique(f.values).size for f in factors]))
    return count == len(points) == len(np.unique(points, axis=0))


def read_table(path):
    """The points of NAME.nc that are done. Raises OSError if it is no NetCDF file, KeyError if it is no table of a sweep."""
    with netCDF4.Dataset(path) as data:
        done = np.ma.filled(data["status"][:], 1) == 0
        front = np.ma.filled(data["front"][:], 0) == 1 if "front" in data.variables else np.zeros(done.size, bool)
        factors, figures = ([column_of(v) for v in data.variables.values() if getattr(v, "long_name", "").startswith(kind)]
                            for kind in ("factor ", "figure "))
        grid = is_grid(factors)
        set_labels(factors + figures)
        for column in factors + figures:
            column.values = column.values[done]
        steady = np.ma.filled(data["steady"][:], 2)[done] if "steady" in data.variables else np.array([])
        return Table(data.title, factors, figures, front[done], int((~done).sum()), grid, int((steady == 0).sum()), getattr(data, "source", ""))


def in_drawn_table(table):
    """The table with all values in the units of their labels."""
    return replace(table, factors=[in_drawn_units(c) for c in table.factors], figures=[in_drawn_units(c) for c in table.figures])


def range_of(column):
    """The values of a column in words: "40 to 60", or the texts of a factor."""
    if column.words:
        return ", ".join(column.words)
    finite = column.values[np.isfinite(column.values)]
    if not finite.size:
        return "no value"
    low, high = (f"{v + 0.0:.4g}" for v in (finite.min(), finite.max()))
    return low if low == high else f"{low} to {high}"


def groups_of(factor):
    """[(middle, which points)]: one for each value, or equal shares of the points of a factor that was sampled."""
    values = np.unique(factor.values)
    if values.size <= BINS:
        return [(v, factor.values == v) for v in values]
    order = np.argsort(factor.values, kind="stable")
    return [(factor.values[part].mean(), np.isin(np.arange(order.size), part)) for part in np.array_split(order, BINS)]


def main_effect(factor, figure):
    """([place], [mean], share): the means of a figure over groups of a factor, and their variance over the whole variance
    (eta squared, the first-order sensitivity of a full grid). Points whose figure is no number are omitted."""
    known = np.isfinite(figure.values)
    groups = [(place, figure.values[which & known]) for place, which in groups_of(factor)]
    groups = [(place, values) for place, values in groups if values.size]
    if not groups:
        return [], [], np.nan
    whole = figure.values[known]
    between = sum(values.size * (values.mean() - whole.mean()) ** 2 for _, values in groups) / whole.size
    share = between / whole.var() if whole.var() > 0.0 else 0.0
    return [place for place, _ in groups], [values.mean() for _, values in groups], share


def regression(factors, figure):
    """([coefficient of each factor], R2) of a linear regression on standardised values. A factor of texts has one level for each
    text, and its coefficient is the standard deviation of its contribution over that of the figure. NaN: too few points."""
    known = np.isfinite(figure.values)
    y = figure.values[known]
    blocks = []
    for factor in factors:
        x = factor.values[known]
        block = np.array([x == k for k in range(1, len(factor.words))], float).T if factor.words else x[:, None]
        blocks.append(block - block.mean(axis=0) if block.size else np.zeros((y.size, 0)))
    scales = [np.where(b.std(axis=0) > 0.0, b.std(axis=0), 1.0) for b in blocks]
    x = np.hstack([b / s for b, s in zip(blocks, scales)])
    if y.size <= x.shape[1] + 1 or not y.std() > 0.0:
        return [np.nan] * len(factors), np.nan
    z = (y - y.mean()) / y.std()
    solved = np.linalg.lstsq(x, z, rcond=None)[0]
    parts = np.split(solved, np.cumsum([b.shape[1] for b in blocks])[:-1])
    coefficients = [np.std(b / s @ c) if f.words else float(c[0]) for f, b, s, c in zip(factors, blocks, scales, parts)]
    return coefficients, 1.0 - float(np.mean((z - x @ solved) ** 2))
