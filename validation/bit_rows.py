"""Records of whole bits from data/full-bits, and the differences between two campaigns with the same bits."""

import math

FT_H = 0.3048 / 3600.0  # m/s
SMALLEST_DEPTH = 0.3e-3  # m per revolution; at smaller depths the bits hardly cut
SPEEDS = {2015: (100, 150, 200), 2019: (80, 120, 160), 2020: (80, 120, 160)}  # nominal, rpm
ROCK = {"SWG": "sierra-white-granite", "BSS": "berea-sandstone"}


def campaign(row):
    """The year of a test. Two rows of a series of 2020 are dated 2021."""
    return min(int(row["year"]), 2020)


def nominal_speed(row):
    return min(SPEEDS[campaign(row)], key=lambda rpm: abs(rpm - float(row["rpm"])))


def depth(row):
    """Depth of cut, m per revolution."""
    return float(row["ROP_ft_hr"]) * FT_H * 60.0 / float(row["rpm"])


def rock(row):
    return ROCK[row["name"][:3]]


def tool(row):
    """The bit's name in records: manufacturer and blades, rock or campaign, nominal speed."""
    if campaign(row) == 2015:
        where = "berea-" if rock(row) == "berea-sandstone" else ""
        return f"ulterra{row['n_blades']}-{where}{nominal_speed(row)}"
    return f"nov{row['n_blades']}-{campaign(row)}-{nominal_speed(row)}"


def records(rows):
    return [{"test": tool(r), "bit": tool(r), "rock": rock(r), "pressure [psi]": 0, "rotary_speed [rpm]": r["rpm"],
             "rate_of_penetration [ft/h]": r["ROP_ft_hr"], "wob [lbf]": r["WOB_lbf"]}
            for r in rows if depth(r) >= SMALLEST_DEPTH]


def interpolated(points, x):
    """Interpolates linearly between points (x, y) with ascending x. Returns None outside their range."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return None


def ratios(rows, blades):
    """Relative differences of the weight in 2020 from that in 2019, at the same depth of cut and nominal speed."""
    found = []
    for speed in SPEEDS[2019]:
        series = {year: sorted((depth(r), float(r["WOB_lbf"])) for r in rows if campaign(r) == year
                               and r["n_blades"] == blades and nominal_speed(r) == speed)
                  for year in (2019, 2020)}
        for d, weight in series[2020]:
            before = interpolated(series[2019], d)
            if before is not None and d >= SMALLEST_DEPTH:
                found.append(weight / before - 1.0)
    return found


def floors(rows):
    """For each of the two bits that were tested again one year later."""
    found = []
    for blades in ("4", "5"):
        r = ratios(rows, blades)
        found.append({"floor": f"nov{blades}", "load": "wob", "mean": f"{abs(sum(r)) / len(r):.4f}",
                      "rms": f"{math.sqrt(sum(x * x for x in r) / len(r)):.4f}",
                      "of": f"{len(r)} rows of 2020 over 2019 at the same depth of cut and speed, less 1"})
    return found
