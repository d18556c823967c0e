"""Evenly spaced samples: another rate, spectra, and the frequencies at which a run of a drilling bit should have lines."""

import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from figures import results

# Brings evenly spaced samples to another rate behind a low pass, so that nothing folds back.

HALF = 40  # samples of the lower rate on either side: flat to 0.43 of that rate, nothing from 0.57 on
BETA = 8.0  # Kaiser's: what folds back is 1e-4 of what was there


def low_pass(up, down, half=HALF, beta=BETA):
    """taps[phase, j] for output between two input samples, (phase / up) of the way: a windowed sinc that
    cuts at half of the lower rate. Each phase sums to 1, so that a constant stays."""
    cutoff = min(1.0, up / down)
    reach = int(np.ceil(half / cutoff))  # input samples on either side
    away = np.arange(1 - reach, reach + 1)[None, :] - np.arange(up)[:, None] / up
    taps = np.sinc(cutoff * away) * np.i0(beta * np.sqrt(np.maximum(0.0, 1.0 - (away / reach)**2)))
    return taps / taps.sum(axis=1, keepdims=True)


def resampled(samples, up, down):
    """At up/down of the rate, from the same first instant. Beyond the ends the samples are taken to stay as they are."""
    taps = low_pass(up, down)
    reach = taps.shape[1] // 2
    padded = np.pad(np.asarray(samples, dtype=float), (reach - 1, reach), mode="edge")
    place = np.arange(((len(samples) - 1) * up) // down + 1) * down
    first, phase = place // up, place % up
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach)
    return np.einsum("nj,nj->n", windows[first], taps[phase])


def interpolated(samples, up, down):
    """The same without a low pass, straight between samples: what it must be compared with."""
    place = np.arange(((len(samples) - 1) * up) // down + 1) * (down / up)
    return np.interp(place, np.arange(len(samples)), samples)


# Spectra of evenly spaced samples: densities after Welch, and the lines of a whole record.

BAND = (2.0, 220.0)  # Hz: below the Nyquist frequency of 512 Hz, above the first turns of the bit


def hann(count):
    """Periodic, so that its own spectrum has three lines."""
    return 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(count) / count)


def welch(samples, rate, seconds=1.0):
    """(frequency, density): Hz, and the samples' unit squared per Hz. Hann windows with half overlap, the mean
    of each removed."""
    length = round(rate * seconds)
    window = hann(length)
    starts = range(0, len(samples) - length + 1, length // 2)
    pieces = np.stack([samples[s:s + length] for s in starts])
    lines = np.fft.rfft((pieces - pieces.mean(axis=1, keepdims=True)) * window)
    density = 2.0 * np.mean(np.abs(lines)**2, axis=0) / (rate * np.sum(window**2))
    return np.fft.rfftfreq(length, 1.0 / rate), density


def ratios(low, low_rate, high, high_rate):
    """(frequency, density at the low rate over that at the high one) in BAND."""
    frequency, above = welch(low, low_rate)
    below = welch(high, high_rate)[1][:len(frequency)]
    inside = (frequency >= BAND[0]) & (frequency <= BAND[1])
    return frequency[inside], above[inside] / below[inside]


def amplitudes(samples, rate):
    """(frequency, amplitude) of the whole record under one Hann window."""
    window = hann(len(samples))
    lines = np.fft.rfft((samples - np.mean(samples)) * window) * 2.0 / window.sum()
    return np.fft.rfftfreq(len(samples), 1.0 / rate), np.abs(lines)


def strongest(samples, rate, count, above=1.0):
    """[(frequency, amplitude)] of the strongest lines from `above` Hz on, the strongest first; between lines of
    the transform by a parabola through the logarithms."""
    frequency, amplitude = amplitudes(samples, rate)
    logs = np.log(np.maximum(amplitude, 1e-300))
    peaks = [i for i in range(1, len(logs) - 1)
             if frequency[i] > above and logs[i - 1] < logs[i] >= logs[i + 1]]
    found = []
    for i in sorted(peaks, key=lambda i: -logs[i])[:count]:
        before, at, after = logs[i - 1:i + 2]
        found.append((frequency[i] + 0.5 * frequency[1] * (before - after) / (before - 2.0 * at + after),
                      amplitude[i]))
    return found


# Frequencies at which a run of a bit that drills should show lines, from its case, its bit and its rate alone.

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


def lines_of_run(folder):
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
