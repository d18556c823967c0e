"""Weight, torque and speeds of bits that drill by themselves, and the spectra of what varies."""

import numpy as np

from figures import results, style

COLUMNS = ("time", "weight_on_bit", "torque_on_bit", "rotary_speed")


def spectrum(time, samples):
    """(frequency, amplitude) under a Hann window: Hz, and the samples' unit."""
    window = np.hanning(len(samples))
    lines = np.fft.rfft((samples - samples.mean()) * window) * 2.0 / window.sum()
    return np.fft.rfftfreq(len(samples), time[1] - time[0]), np.abs(lines)


def draw_run(axes, folder, name, marks):
    time, wob, tob, speed = results.history(folder, *COLUMNS)
    axes[0].plot(time, 1e-3 * wob, color=style.BLUE, linewidth=0.7)
    axes[0].plot(time, 1e-3 * tob, color=style.RED, linewidth=0.7)
    axes[0].set(title=name, ylabel="WOB (kN, blue), TOB (kN m, red)")
    axes[1].plot(time, speed * 30.0 / np.pi, color=style.GREEN, linewidth=0.7)
    axes[1].set(xlabel="time (s)", ylabel="speed of the bit (rpm)")
    late = time > 0.5 * time[-1]
    for samples, colour, scale in ((speed[late] * 30.0 / np.pi, style.GREEN, 1.0), (wob[late], style.BLUE, 1e-3)):
        frequency, amplitude = spectrum(time[late], scale * samples)
        axes[2].loglog(frequency[1:], np.maximum(amplitude[1:], 1e-6), color=colour, linewidth=0.7)
    for frequency in marks:
        axes[2].axvline(frequency, color=style.GREY, linestyle=":", linewidth=1.0)
    axes[2].set(xlabel="frequency (Hz)", ylabel="amplitude (rpm green, kN blue)")


def expected(folder):
    """Hz: frequencies that string and mass would show by themselves."""
    diagnosis = results.summary(folder).get("diagnosis", {})
    found = [diagnosis.get(f"{mode}_frequency_expected_hz", 0.0) for mode in ("torsional", "axial")]
    return [f for f in found if f > 0.0]


def draw_folder(folder, name):
    """Of any run with forces."""
    figure, axes = style.panels(3, 1, (6.5, 7.6))
    draw_run(axes, folder, name, expected(folder))
    return figure


def draw(inputs):
    figure, axes = style.panels(3, 2, (9.0, 7.6))
    for column, (run, name) in enumerate((("stick-slip", "Long string: stick-slip"), ("bounce", "Bit R in granite: bounce"))):
        folder = inputs.folder(run)
        draw_run(axes[:, column], folder, name, expected(folder))
    return figure
