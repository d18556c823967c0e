"""The numbers of README.md, from the data of this study."""

import math
from pathlib import Path

from study_tools import read_rows

HERE = Path(__file__).parent
GIVEN = ["flats of 0.1 mm, and wear", "with flats of 0.1 mm", "at 128 azimuths", "from 3 mm to 0.75 mm", "64 segments, the default", "edges of 3 mm",
         "from 93.6 mm3 with 3 mm to 160.7 mm3 with 1.05 mm", 
         "12 turns that stand for 100 m, edges of 2 mm", "Rims have 256 segments", "a factor of 2", "rate of 15 m/h", "grows over 100 m", "rate of penetration over 100 m",
         "flats of 0.1 mm, the specific", "order 2 where", "of six\ncutters, 5 to 7 and 21 to 23; all others agree within 0.1 mm3 from 10 wear steps on",
         "ten turns with", "rate at 100 m is", "After two turns without", "over\nfive levels", "at the axis and large ones", "32 layouts that drill 50 m"]
AT_GAGE = [f"cutter-{i}" for i in range(24, 29)]
TDBD, MODEL = "flat of TDBD, mm2", "flat of Glowka's model, mm2"
WARM, OF_MODEL = "temperature in TDBD, degC", "temperature in Glowka's model, degC"


def deviation(rows, a, b):
    """Largest, in percent of b."""
    return 100 * max(abs(row[a] / row[b] - 1) for row in rows)


def metre_rows(rock, source):
    return [r for r in read_rows(HERE / "metres.csv") if (r["rock"], r["source"]) == (rock, source)]


def over_metres(rock, source, quantity):
    """First and last value."""
    rows = metre_rows(rock, source)
    return rows[0][quantity], rows[-1][quantity]


def at_metres(rock, source, quantity, metres):
    """Linear between rows."""
    rows = metre_rows(rock, source)
    low, high = next(pair for pair in zip(rows, rows[1:]) if pair[0]["metres"] <= metres <= pair[1]["metres"])
    share = (metres - low["metres"]) / (high["metres"] - low["metres"])
    return low[quantity] + share * (high[quantity] - low[quantity])


def convergence():
    worn = {(r["key"], str(r["value"])): r["worn volume, mm3"] for r in read_rows(HERE / "convergence.csv")}
    coarse, fine = worn["rock.edge_length", "3 mm"], worn["rock.edge_length", "1.05 mm"]
    yield "volume is {:.1f} mm3 with the shipped", coarse
    yield "and {:.1f} mm3 with {:.2f} mm: the", fine, 1.05
    yield "change it by {:.1f} %", 100 * (coarse / fine - 1)
    yield "time step it is {:.1f} mm3", worn["time.step", "0.5 ms"]
    yield "in a wear step {:.1f} mm3", worn["wear.largest_growth", "0.02"]
    yield "most: {:.1f} mm3 with double and {:.1f} mm3 with half", worn["wear.acceleration", "12000"], worn["wear.acceleration", "3000"]


def flats():
    rows = read_rows(HERE / "flats.csv")
    fine = [r["worn volume, mm3"] for r in rows if r["rim segments"] == 256]
    limit = rows[0]["in half-planes, mm3"]
    yield "volume is between {:.2f} and {:.2f} mm3", min(fine), max(fine)
    yield "half-planes give {:.2f} mm3", limit
    coarse = next(r["worn volume, mm3"] for r in rows if r["rim segments"] == 64)
    yield "the volume is {:.1f} % too small", 100 * (1 - coarse / limit)


def glowka():
    rows = read_rows(HERE / "cutters.csv")
    medium, hard = ([r for r in rows if r["rock"] == rock and r["cutter"] not in AT_GAGE] for rock in ("medium", "hard"))
    yield "agree within {:.1f} % in the medium rock", deviation(medium, TDBD, MODEL)
    yield "and {:.1f} % in the hard rock, and", deviation(hard, TDBD, MODEL)
    yield "temperatures within {:.1f} %", deviation(medium + hard, WARM, OF_MODEL)
    gage = next(r for r in rows if r["rock"] == "medium" and r["cutter"] == AT_GAGE[0])
    yield "by a factor of {:.1f} in the medium rock", gage[MODEL] / gage[TDBD]
    load, rate = "weight on bit, kN", "rate of penetration, m/h"
    yield "from {:.1f} to {:.1f} kN in the medium rock", *over_metres("medium", "TDBD, constant rate", load)
    yield "from {:.1f} to {:.1f} kN in the hard rock", *over_metres("hard", "TDBD, constant rate", load)
    yield "model's grows from {:.1f} to {:.1f} kN", *over_metres("medium", "Glowka's model, constant rate", load)
    yield "and from {:.1f} to {:.1f} kN (", *over_metres("hard", "Glowka's model, constant rate", load)
    first = next(r["metres"] for r in read_rows(HERE / "metres.csv") if r["source"] == "TDBD, constant rate")
    yield "mean of the first {:.1f} m", first
    after = {(rock, source): at_metres(rock, f"{source}, constant weight", rate, 100) for rock in ("medium", "hard") for source in ("TDBD", "Glowka's model")}
    yield "at 100 m is {:.1f} m/h in the medium rock and {:.1f} m/h", after["medium", "TDBD"], after["hard", "TDBD"]
    yield "the model's is {:.1f} and {:.1f} m/h", after["medium", "Glowka's model"], after["hard", "Glowka's model"]
    yield "go on to {:.0f} m and", min(rows[-1]["metres"] for rows in (metre_rows(rock, "TDBD, constant weight") for rock in ("medium", "hard")))


def wear_steps():
    rows = read_rows(HERE / "wear_steps.csv")
    every, counts = "time steps between wear steps", "wear steps"
    error = next(key for key in rows[0] if key.startswith("difference"))
    levels, limit = rows[:-1], rows[-1]
    yield "turns with {:.0f} to {:.0f} wear steps", levels[0][counts], levels[-1][counts]
    yield "from one with {:.0f} by {:.2f} to {:.2f} mm3", limit[counts], levels[0][error], levels[-1][error]
    logs = [(math.log(r[every]), math.log(r[error])) for r in levels]
    x, y = (sum(column) / len(logs) for column in zip(*logs))
    yield "order {:.2f} by least", sum((a - x) * (b - y) for a, b in logs) / sum((a - x) ** 2 for a, b in logs)
    yield "{:.2f} between the longest two", math.log2(levels[0][error] / levels[1][error])


def layouts():
    rows = read_rows(HERE / "layouts.csv")
    scatter = [r["scatter of worn volumes over their mean"] for r in rows]
    energy = [r["specific energy, MPa"] for r in rows]
    yield "between {:.3f} and {:.3f}, and {:.0f} layouts", min(scatter), max(scatter), sum(r["on the front"] == "yes" for r in rows)
    yield "it needs {:.1f} MPa, the least work is {:.1f} MPa", energy[scatter.index(min(scatter))], min(energy)


def stated():
    for part in (convergence, wear_steps, flats, glowka, layouts):
        yield from part()
