"""Wear of bit B: convergence in mesh and steps, comparison with half-planes and with Glowka's model, and layouts that wear evenly."""

import csv
import math
from pathlib import Path

import numpy as np
from study_tools import ROOT, read_rows, write_rows

HERE = Path(__file__).resolve().parent
CASE = ROOT / "cases/wear-bit-b.toml"
SHIPPED = {"rock.edge_length": "3 mm", "time.step": "2 ms", "wear.largest_growth": 0.005, "wear.acceleration": 6000, "wear.from": "0 s"}
TURNS = 8 * 6000  # times the acceleration
CONVERGENCE = [("rock.edge_length", ["3 mm", "2.1 mm", "1.5 mm", "1.05 mm"]), ("time.step", ["1 ms", "0.5 ms"]), ("wear.largest_growth", [0.02]),
               ("wear.acceleration", [12000, 3000])]
EDGES, SEGMENTS = ["3 mm", "2.1 mm", "1.5 mm", "1.05 mm", "0.75 mm"], [64, 128, 256]
WEAR_STEPS = [512, 256, 128, 64, 32, 8]  # time steps between two wear steps; the last is the limit of the others
START_FLAT, STRESS, GAGE = "0.100", 100e6, 23  # mm; Pa; the cutters before these are not at the gage
ROCKS = {"medium": (100e6, 60e6), "hard": (200e6, 120e6)}  # Pa: specific energy, stress under a flat
RATE = 15.0  # m/h
FRESH_WEIGHT, FRESH_TORQUE = {"medium": 16e3, "hard": 32e3}, {"medium": 1250, "hard": 2500}  # N, N m: approximate loads at RATE
METRES = range(0, 101, 10)

# The figure, and functions that study.toml uses.


def at(rows, column, metres):
    """A column of metres.csv, linear between rows."""
    low, high = next(pair for pair in zip(rows, rows[1:]) if pair[0]["metres"] <= metres <= pair[1]["metres"])
    share = (metres - low["metres"]) / (high["metres"] - low["metres"])
    return low[column] + share * (high[column] - low[column])


def rock_colours():
    from figures import style
    return {"medium": style.BLUE, "hard": style.RED}


def draw_metres(axes, drive, quantity):
    for rock, colour in rock_colours().items():
        for source, dash in (("TDBD", "solid"), ("Glowka's model", "dashed")):
            rows = read_rows(HERE / "metres.csv").where("rock", rock, "source", f"{source}, constant {drive}")
            axes.plot(rows["metres"], rows[quantity], color=colour, linestyle=dash, label=f"{source}, {rock} rock")


def draw_flats(axes):
    from figures import style
    for rock, colour in rock_colours().items():
        rows = read_rows(HERE / "cutters.csv").where("rock", rock)
        axes.plot(range(1, len(rows) + 1), rows["flat of TDBD, mm2"], "o", color=colour)
        axes.plot(range(1, len(rows) + 1), rows["flat of Glowka's model, mm2"], "x", color=style.GREY)


# Wear of flats in the half-planes of a bit that drills steadily. It shares no code with TDBD. Flats wear where their edges cut:
# V' = k/H stress A v, with A the area of the flat behind the edge in rock. The (r, z) half-planes of a ring of azimuths keep the
# depth of the bottom over r. A cutter is a circle that leans by its back rake, seen along the motion, with a flat; it passes one
# half-plane in each step, and is in rock where it is deeper than the bottom.


class Cutters:
    """The cutters of the rows of a cutter table with flats (wear_mm)."""

    def __init__(self, rows, samples=8001):
        def column(name):
            return np.array([float(row[name]) for row in rows])
        self.radius, self.place = column("dia_mm") / 2e3, column("r_tip_mm") / 1e3
        self.azimuth, self.depth = np.radians(column("phi_deg")), -column("h_tip_mm") / 1e3
        self.profile, self.rake = np.radians(column("profile_angle_deg")), np.radians(column("back_rake_deg"))
        self.worn = column("wear_mm") / 1e3 / np.cos(self.rake)  # m, on the face
        self.across = np.outer(self.radius, np.linspace(-1, 1, samples))
        self.rise = self.radius[:, None] - np.sqrt(self.radius[:, None]**2 - self.across**2)

    def rim(self, i):
        """r and z of a cutter's rim."""
        into = -np.maximum(self.rise[i], self.worn[i]) * np.cos(self.rake[i])
        sine, cosine = np.sin(self.profile[i]), np.cos(self.profile[i])
        return self.place[i] + self.across[i] * cosine + into * sine, self.depth[i] - self.across[i] * sine + into * cosine

    def section(self, i):
        """Section of the cutter at its flat, along the axis, m2."""
        a, y = self.radius[i], self.worn[i]
        return a * a * np.arccos(1 - y / a) - (a - y) * np.sqrt(2 * a * y - y * y)

    def volume(self, i):
        """Volume that the cylinder has lost, m3: cot b times the integral of the section."""
        a, y = self.radius[i], self.worn[i]
        s = np.sqrt(2 * a * y - y * y)
        return (a * a * (s - (a - y) * np.arccos(1 - y / a)) - s**3 / 3) / np.tan(self.rake[i])


def deepest(r, z, columns):
    """The deepest point of a rim in each column."""
    bottom = np.full(len(columns), -np.inf)
    turns = [0, *(np.flatnonzero(np.diff(np.sign(np.diff(r)))) + 1), len(r) - 1]
    for begin, end in zip(turns[:-1], turns[1:]):
        a, b = r[begin:end + 1], z[begin:end + 1]
        if a[0] > a[-1]:
            a, b = a[::-1], b[::-1]
        some = slice(np.searchsorted(columns, a[0]), np.searchsorted(columns, a[-1]))
        bottom[some] = np.maximum(bottom[some], np.interp(columns[some], a, b))
    return bottom


def worn_volumes(rows, run, azimuths=128, column=1e-5):
    """Worn volume of each cutter, m3. `run`: advance (m per turn), speed (rad/s), turns, first (turns without wear), rate (m3/(N m), times the
    acceleration), stress (Pa)."""
    c = Cutters(rows)
    start = [c.volume(i) for i in range(len(rows))]
    columns = (np.arange(int(0.12 / column)) + 0.5) * column
    rims = [c.rim(i) for i in range(len(rows))]
    reach = [deepest(*rim, columns) for rim in rims]
    bottom = np.tile(np.max(reach, axis=0), (azimuths, 1))
    step = 2 * np.pi / run["speed"] / azimuths
    for k in range(round(run["turns"] * azimuths)):
        down = run["advance"] * (k + 0.5) / azimuths
        for i in range(len(rows)):
            here = bottom[(int(np.floor(c.azimuth[i] / (2 * np.pi) * azimuths)) + k) % azimuths]
            if k >= run["first"] * azimuths:
                r, z = rims[i]
                cuts = (c.rise[i] <= c.worn[i]) & (z + down > np.interp(r, columns, here))
                area = ((c.worn[i] - c.rise[i])[cuts] / np.sin(c.rake[i])).sum() * (c.across[i][1] - c.across[i][0])
                lost = run["rate"] * run["stress"] * area * run["speed"] * c.place[i] * step
                c.worn[i] += lost * np.tan(c.rake[i]) / c.section(i)
                rims[i] = c.rim(i)
                reach[i] = deepest(*rims[i], columns)
            np.maximum(here, reach[i] + down, out=here)
    return [c.volume(i) - v for i, v in enumerate(start)]


# Convergence.


def wear(m, case, settings):
    found = m.run(case, settings).summary["wear"]
    assert found["volume_ledger_defect"] <= 1e-12
    return found


def volume(found, cutters=None):
    """Worn volume of the first cutters or of all, mm3."""
    return 1e9 * sum(cutter["worn_volume_m3"] for cutter in found["cutters"][:cutters])


def rows_of_convergence(m):
    for key, value in ((key, value) for key, values in CONVERGENCE for value in values):
        changes = {**SHIPPED, key: value}
        found = wear(m, CASE, changes | {"time.revolutions": TURNS / float(changes["wear.acceleration"])})
        yield {"key": key, "value": value, "worn volume, mm3": round(volume(found), 3), "wear steps": found["wear_steps"]}


def rows_of_wear_steps(m):
    """Ten turns after two turns without wear, so that wear begins in steady cuts."""
    found = []
    for every in WEAR_STEPS:
        w = wear(m, CASE, {**SHIPPED, "wear.from": "1 s", "wear.every_steps": every, "wear.largest_growth": 0.1, "time.revolutions": 12})
        found.append((every, w["wear_steps"], 1e9 * np.array([c["worn_volume_m3"] for c in w["cutters"]])))
    limit = found[-1][2]
    for every, count, volumes in found:
        yield {"time steps between wear steps": every, "wear steps": count, "worn volume, mm3": round(volumes.sum(), 3),
               "difference of the cutters' volumes from the last row, mm3, root of the sum of squares": round(np.linalg.norm(volumes - limit), 4)}


def write_flat_bit(m):
    """A bit with sharp cutters that begin with a flat; the rows of its cutter table."""
    bits = ROOT / "cases/bits"
    with open(bits / "bit-b.csv", newline="", encoding="utf-8") as file:
        rows = [{**row, "wear_mm": START_FLAT} for row in csv.DictReader(file)]
    write_rows(m.temporary / "bit.csv", rows)
    m.file("bit.toml", (bits / "bit-b.toml").read_text(encoding="utf-8").replace("bit-b.csv", "bit.csv").replace('chamfer = "0.3 mm"', 'chamfer = "0 mm"'))
    return rows


def rows_of_flats(m):
    """Cutters that wear at their flats alone, compared with the half-planes."""
    rows = write_flat_bit(m)
    case = m.case(CASE.read_text(encoding="utf-8").replace("bits/bit-b.toml", "bit.toml") + '\n[wear.areas.faces]\nkind = "face"\nlaw = "none"\n')
    steady = {"advance": 15 / 3600 / 2, "speed": 4 * np.pi, "turns": 9, "first": 1, "rate": 6000 * 1e-5 / 50e9, "stress": STRESS}
    limit = 1e9 * sum(worn_volumes(rows, steady)[:GAGE])
    for edge, segments in [(e, 256) for e in EDGES] + [("1.5 mm", s) for s in SEGMENTS[:-1]]:
        found = wear(m, case, {"rock.edge_length": edge, "bit.set.mesh.rim_segments": segments, "wear.largest_growth": 0.0025})
        yield {"edge": edge, "rim segments": segments, "worn volume, mm3": round(volume(found, GAGE), 3), "in half-planes, mm3": round(limit, 3)}


# Glowka's model over 100 m in two rocks.


def cases_of(m):
    """The case at a constant rate, and that at a constant weight."""
    text = (HERE / "tdbd.toml").read_text(encoding="utf-8").replace("../../../cases/bits/bit-b.toml", "bit.toml")
    before, rest = text.split("[motion]")
    after = rest[rest.index("[time]"):].replace("slip_speed = 0.0\n", "").replace("revolutions = 13", 'duration = "8 s"')
    weight = (HERE / "weight.toml").read_text(encoding="utf-8")
    return m.case(text, "rate.toml"), m.case(before + weight[weight.index("[motion]"):] + "\n" + after.replace('step = "2 ms"', 'step = "1 ms"'), "weight.toml")


def modelled(m, rock, metres):
    """Results of Glowka's model after a number of metres: {(cutter, quantity): value}. ("bit", "weight") is the weight of the sharp bit."""
    energy, stress = ROCKS[rock]
    text = (HERE / "glowka.toml").read_text(encoding="utf-8").replace("../../../cases/bits/bit-b.toml", str(m.temporary / "bit.toml"))
    text = text.replace('eps = "100 MPa"', f"eps = {energy}").replace('flat_stress = "60 MPa"', f"flat_stress = {stress}")
    case, out = m.case(text.replace('distance = "100 m"', f"distance = {max(metres, 1e-3)}"), "glowka.toml"), m.temporary / "glowka"
    m.output("tdbd-compare", case, "-o", out, "--force")
    found = {(r["part"], r["quantity"]): float(r["value"]) for r in read_rows(out / "parts.csv") if r["model"] == "glowka"}
    return found | {("bit", "weight"): float(read_rows(out / "comparison.csv").where("model", "glowka", "quantity", "weight")[0]["value"])}


def cutter_row(rock, c, glowka):
    return {"rock": rock, "cutter": c["name"], "flat of TDBD, mm2": round(1e6 * c["flat_area_m2"], 3),
            "flat of Glowka's model, mm2": round(1e6 * glowka[c["name"], "wear_flat"], 3),
            "worn volume of TDBD, mm3": round(1e9 * c["worn_volume_m3"], 4), "temperature in TDBD, degC": round(c["temperature_k"] - 273.15, 1),
            "temperature in Glowka's model, degC": round(glowka[c["name"], "temperature"], 1)}


def metre_row(rock, source, metres, weight, rate):
    return {"rock": rock, "source": source, "metres": round(metres, 2), "weight on bit, kN": round(weight / 1e3, 4), "rate of penetration, m/h": round(rate, 4)}


def metre_rows(rock, runs, table, of_model):
    """The model: flats carry load with their whole area, and the load of sharp cutters is proportional to the rate."""
    stress, load = ROCKS[rock][1], FRESH_WEIGHT[rock]
    for distance, glowka in zip(METRES, of_model, strict=True):
        flats = sum(stress * glowka[f"cutter-{c['cutter']}", "wear_flat"] * math.cos(math.radians(float(c["profile_angle_deg"]))) for c in table)
        sharp = glowka["bit", "weight"]
        yield metre_row(rock, "Glowka's model, constant rate", distance, sharp + flats, RATE)
        yield metre_row(rock, "Glowka's model, constant weight", distance, load, RATE * (load - flats) / sharp)
    for drive, found in runs.items():
        over = found["over_distance"]
        for metres, weight, rate in zip(over["distance_m"], over["weight_on_bit_n"], over["rate_of_penetration_m_per_s"], strict=True):
            yield metre_row(rock, f"TDBD, constant {drive}", metres, weight, 3600 * rate)


def measure_glowka(m):
    table, (at_rate, at_weight), cutters, metres = write_flat_bit(m), cases_of(m), [], []
    for rock, (energy, stress) in ROCKS.items():
        of_rock = {"forces.eps": energy, "forces.cutter_body.stress": stress, "bit.set.mesh.rim_segments": 256}
        runs = {"rate": wear(m, at_rate, of_rock),
                "weight": wear(m, at_weight, of_rock | {"motion.weight_on_bit": FRESH_WEIGHT[rock], "motion.torque_at_start": FRESH_TORQUE[rock]})}
        of_model = [modelled(m, rock, distance) for distance in METRES]
        cutters += [cutter_row(rock, c, of_model[-1]) for c in runs["rate"]["cutters"]]
        metres += metre_rows(rock, runs, table, of_model)
    m.write("cutters.csv", cutters)
    m.write("metres.csv", metres)


# Layouts: cases/sweeps/even-wear.toml.

LAYOUTS = {**{f"overlap, {place}": (f"bit.set.design.overlap.{place}", 1, 2) for place in ("axis", "nose", "shoulder")},
           **{f"back rake, {place}, deg": (f"bit.set.design.back_rake.{place}", 1, 1) for place in ("axis", "nose", "shoulder")},
           "scatter of worn volumes over their mean": ("wear.worn_volume_unevenness", 1, 4), "worn volume, mm3": ("wear.worn_volume_m3", 1e9, 2),
           "largest of a cutter, mm3": ("wear.largest_worn_volume_m3", 1e9, 3), "specific energy, MPa": ("mechanical_specific_energy_pa", 1e-6, 3),
           "weight on bit, kN": ("wob_mean_n", 1e-3, 3)}


def rows_of_layouts(m):
    import xarray
    out = m.temporary / "even-wear.nc"
    m.output("tdbd", "sweep", ROOT / "cases/sweeps/even-wear.toml", "-o", out)
    with xarray.open_dataset(out) as table:
        for i in range(table.sizes["point"]):
            point = table.isel(point=i)
            if int(point["status"]) == 0:
                yield {"layout": i + 1, **{label: round(float(point[name]) * scale, digits) for label, (name, scale, digits) in LAYOUTS.items()},
                       "on the front": "yes" if int(point["front"]) else ""}


def measure(m):
    """Parts for --only: flats.csv, convergence.csv, wear_steps.csv, layouts.csv, glowka (cutters.csv and metres.csv)."""
    for file, rows in (("flats.csv", rows_of_flats), ("convergence.csv", rows_of_convergence), ("wear_steps.csv", rows_of_wear_steps)):
        if m.includes(file):
            m.write(file, rows(m))
    if m.includes("layouts.csv"):
        m.write("layouts.csv", sorted(rows_of_layouts(m), key=lambda r: r["scatter of worn volumes over their mean"]))
    if m.includes("glowka"):
        measure_glowka(m)
