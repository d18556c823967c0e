"""Wear of flats in the half-planes of a bit that drills steadily, as a second way to the limit of TDBD's runs. It shares no code
with TDBD. Flats wear where their edges cut: V' = k/H stress A v, with A the area of the flat behind the edge in rock.

The (r, z) half-planes of a ring of azimuths keep the depth of the bottom over r. A cutter is a circle that leans by its back
rake, seen along the motion, with a flat; it passes one half-plane in each step, and is in rock where it is deeper than the bottom.
"""

import numpy as np

SAMPLES = 8001  # of a cutter's rim


class Cutters:
    """Of the rows of a cutter table with flats (wear_mm)."""

    def __init__(self, rows):
        def column(name):
            return np.array([float(row[name]) for row in rows])
        self.radius, self.place = column("dia_mm") / 2e3, column("r_tip_mm") / 1e3
        self.azimuth, self.depth = np.radians(column("phi_deg")), -column("h_tip_mm") / 1e3
        self.profile, self.rake = np.radians(column("profile_angle_deg")), np.radians(column("back_rake_deg"))
        self.worn = column("wear_mm") / 1e3 / np.cos(self.rake)  # m, on the face
        self.across = np.outer(self.radius, np.linspace(-1, 1, SAMPLES))
        self.rise = self.radius[:, None] - np.sqrt(self.radius[:, None]**2 - self.across**2)

    def rim(self, i):
        """r and z of a cutter's rim."""
        into = -np.maximum(self.rise[i], self.worn[i]) * np.cos(self.rake[i])
        sine, cosine = np.sin(self.profile[i]), np.cos(self.profile[i])
        return self.place[i] + self.across[i] * cosine + into * sine, self.depth[i] - self.across[i] * sine + into * cosine

    def section(self, i):
        """m2, of the cutter at its flat, along the axis."""
        a, y = self.radius[i], self.worn[i]
        return a * a * np.arccos(1 - y / a) - (a - y) * np.sqrt(2 * a * y - y * y)

    def volume(self, i):
        """m3, that the cylinder has lost: cot b times the integral of the section."""
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
    """m3, by cutter. `run`: advance (m per turn), speed (rad/s), turns, first (turns without wear), rate (m3/(N m), times the
    acceleration), stress (Pa)."""
    c = Cutters(rows)
    count = len(rows)
    start = [c.volume(i) for i in range(count)]
    columns = (np.arange(int(0.12 / column)) + 0.5) * column
    rims = [c.rim(i) for i in range(count)]
    reach = [deepest(*rim, columns) for rim in rims]
    bottom = np.tile(np.max(reach, axis=0), (azimuths, 1))
    step = 2 * np.pi / run["speed"] / azimuths
    for k in range(round(run["turns"] * azimuths)):
        down = run["advance"] * (k + 0.5) / azimuths
        for i in range(count):
            here = bottom[(int(np.floor(c.azimuth[i] / (2 * np.pi) * azimuths)) + k) % azimuths]
            if k >= run["first"] * azimuths:
                r, z = rims[i]
                cuts = (c.rise[i] <= c.worn[i]) & (z + down > np.interp(r, columns, here))
                strips = (c.worn[i] - c.rise[i])[cuts] / np.sin(c.rake[i])
                area = strips.sum() * (c.across[i][1] - c.across[i][0])
                lost = run["rate"] * run["stress"] * area * run["speed"] * c.place[i] * step
                c.worn[i] += lost * np.tan(c.rake[i]) / c.section(i)
                rims[i] = c.rim(i)
                reach[i] = deepest(*rims[i], columns)
            np.maximum(here, reach[i] + down, out=here)
    return [c.volume(i) - v for i, v in enumerate(start)]
