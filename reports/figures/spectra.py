"""Spectra of evenly spaced samples: densities after Welch, and the lines of a whole record."""

import numpy as np

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
