"""Brings evenly spaced samples to another rate behind a low pass, so that nothing folds back."""

import numpy as np

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
