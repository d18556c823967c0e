"""Frequencies at which a run of a bit that drills should show lines, from its case, its bit and its rate alone."""

import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from figures import results


@dataclass(frozen=True)
class Lines:
    """Hz; 0: there is none."""

    rotation: float
    blades: float  # blades times rotation
    torsion: float  # of string and mass alone
    mount: float  # of the rock on its mount, alone
    maintenance: float  # of the rock's mesh
    beds: float  # pairs of beds that the bit passes, along their normal
    crossing: float  # pairs of beds that the outermost cutter crosses on its way around


def bed_period(rock):
    """m along the normal: a hard and a soft bed together. Beds must be equally thick."""
    tops = [layer["top"] for layer in rock.get("layers", [])]
    return 2.0 * (tops[-1] - tops[0]) / (len(tops) - 1) if len(tops) > 1 else math.inf


def of_run(folder):
    """The lines of a result folder of `tdbd run`; its mean rate of penetration passes the beds."""
    case = tomllib.loads((Path(folder) / "case.toml").read_text(encoding="utf-8"))
    summary, bit = results.summary(folder), results.read_json(folder, "bit.json")
    rotation = case["motion"]["rotary_speed"] / (2.0 * math.pi)
    rock, mount = case["rock"], case.get("rock_mount")
    dip, period = rock.get("dip", 0.0), bed_period(rock)
    return Lines(rotation=rotation,
                 blades=rotation * len({c["blade"] for c in bit["cutters"]}),
                 torsion=summary["diagnosis"]["torsional_frequency_expected_hz"],
                 mount=math.sqrt(mount["stiffness"] / mount["mass"]) / (2.0 * math.pi) if mount else 0.0,
                 maintenance=1.0 / (case["maintenance"]["every"] * case["time"]["step"]),
                 beds=summary["rop_mean_m_per_s"] * math.cos(dip) / period,
                 crossing=2.0 * math.pi * rotation * bit["gage_radius_m"] * math.sin(dip) / period)


def bedding_comb(lines, up_to):
    """Hz: |k rotation +- m beds|, m odd, since equally thick beds are a square wave; m up to 3.

    A cutter at radius r and azimuth a is at n.x = -r sin(dip) cos(w t + a) + v t cos(dip) + const, of which the
    strength of the beds is a periodic function: Fourier's series of that, Jacobi and Anger's of its cosine."""
    orders = np.arange(0, math.ceil(up_to / lines.rotation) + 1)
    comb = np.abs(orders[:, None] * lines.rotation + np.array([-3, -1, 1, 3]) * lines.beds).ravel()
    return np.unique(comb[comb <= up_to])


def nearest_order(lines, frequency):
    """(k, m) of the line |k rotation + m beds| nearest to a frequency, m odd, k at least 0."""
    whole = round(frequency / lines.rotation)
    tried = [(k, m) for k in range(max(0, whole - 2), whole + 3) for m in (-3, -1, 1, 3)]
    return min(tried, key=lambda order: abs(order[0] * lines.rotation + order[1] * lines.beds - frequency))
