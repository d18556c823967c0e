"""Weight and torque at 1000 Hz and brought to 512 Hz: traces and spectra, homogeneous rock beside dipping beds."""

import numpy as np

from figures import case_lines, resample, results, spectra, style

RATE, UP, DOWN = 1000.0, 64, 125
LOW = RATE * UP / DOWN  # Hz
START_UP = 2.0  # s, of a run of 10; a quick run is shorter and gives a fifth
COLUMNS = (("high-frequency", "Rock that is the same everywhere"),
           ("high-frequency-beds", "Beds of 65 and 85 MPa, 8 mm thick, that dip by 30 degrees"))
LOADS = (("weight_on_bit", "WOB", style.BLUE), ("torque_on_bit", "TOB", style.RED))


def loads(folder):
    """Time (s) from the end of the start-up, then weight and torque."""
    time, *values = results.history(folder, "time", *(name for name, *_ in LOADS))
    late = time > min(START_UP, 0.2 * time[-1])
    return time[late] - time[late][0], [v[late] for v in values]


def draw_traces(axes, time, values):
    """Two seconds."""
    for samples, (_, name, colour) in zip(values, LOADS):
        shown = time <= 2.0
        axes.plot(time[shown], 100.0 * (samples[shown] / samples.mean() - 1.0), color=colour, linewidth=0.8, label=name)
    axes.set(xlabel="time (s)", ylabel="WOB, TOB: off the mean (%)")


def draw_both_rates(axes, time, values):
    """Half a second of both rates."""
    for samples, (_, name, colour) in zip(values, LOADS):
        mean = samples.mean()
        low = resample.resampled(samples, UP, DOWN)
        low_time = np.arange(len(low)) / LOW
        shown, low_shown = (time >= 1.0) & (time <= 1.5), (low_time >= 1.0) & (low_time <= 1.5)
        axes.plot(time[shown], 100.0 * (samples[shown] / mean - 1.0), color=colour, linewidth=0.6,
                  label=f"{name}, 1000 Hz")
        axes.plot(low_time[low_shown], 100.0 * (low[low_shown] / mean - 1.0), ".", color=colour, markersize=2.5,
                  label=f"{name}, 512 Hz")
    axes.set(xlabel="time (s)", ylabel="off the mean (%)")


def draw_spectra(axes, values, lines):
    for samples, (_, name, colour) in zip(values, LOADS):
        for series, rate, width in ((samples, RATE, 0.8), (resample.resampled(samples, UP, DOWN), LOW, 2.4)):
            frequency, density = spectra.welch(series / samples.mean(), rate)
            axes.loglog(frequency[1:], density[1:], color=colour, linewidth=width, alpha=1.0 if rate == RATE else 0.35)
    named = [(lines.rotation, "rotation"), (lines.blades, "blades"), (lines.torsion, "torsion"), (lines.mount, "rock on its mount"),
             (lines.crossing, "gage crosses beds"), (lines.maintenance, "mesh maintenance"), (0.5 * LOW, "half of 512 Hz")]
    for frequency, name in named:
        if frequency > 0.0:
            axes.axvline(frequency, color=style.GREY, linestyle=":", linewidth=0.8)
            axes.text(frequency, 0.98, f"{name}, {frequency:.3g} Hz", transform=axes.get_xaxis_transform(), rotation=90,
                      ha="right", va="top", fontsize=6.5, color=style.BLACK)
    axes.set(xlabel="frequency (Hz)", ylabel="density over mean² (1/Hz)", xlim=(1.0, 0.5 * RATE), ylim=(3e-11, 0.1))


def draw_ratios(axes, values):
    for samples, (_, name, colour) in zip(values, LOADS):
        for make, shape, how in ((resample.resampled, "-", "with the low pass"), (resample.interpolated, ":", "straight between readings")):
            frequency, ratio = spectra.ratios(make(samples, UP, DOWN), LOW, samples, RATE)
            axes.semilogy(frequency, ratio, shape, color=colour, linewidth=0.9, label=f"{name} {how}")
    axes.set(xlabel="frequency (Hz)", ylabel="density at 512 Hz\nover that at 1000 Hz", xlim=(0.0, spectra.BAND[1]), ylim=(0.4, 10.0))


def draw(inputs):
    figure, axes = style.panels(4, 2, (10.0, 11.5), sharey="row", height_ratios=(1.0, 1.0, 1.7, 0.8))
    for column, (run, title) in zip(axes.T, COLUMNS):
        folder = inputs.folder(run)
        time, values = loads(folder)
        draw_traces(column[0], time, values)
        spread = ", ".join(f"{name} {100.0 * v.std() / v.mean():.2g} %" for v, (_, name, _) in zip(values, LOADS))
        column[0].set_title(f"{title}\nrms over mean: {spread}")
        draw_both_rates(column[1], time, values)
        draw_spectra(column[2], values, case_lines.of_run(folder))
        draw_ratios(column[3], values)
    for right in axes[:, 1]:
        right.set_ylabel("")
    axes[0, 0].legend(loc="upper right", ncols=2)
    axes[1, 0].legend(loc="upper right", ncols=2, fontsize=7)
    axes[3, 0].legend(loc="upper left", ncols=2, fontsize=7)
    return figure
