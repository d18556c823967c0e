"""The lines that dipping beds make in weight and torque, and where rotation and advance put them."""

import numpy as np

from figures import case_lines, results, spectra, style

START_UP = 2.0  # s
TO = 45.0  # Hz


def draw_load(axes, folder, lines, load):
    name, words, colour = load
    time, samples = results.history(folder, "time", name)
    samples = samples[time > min(START_UP, 0.2 * time[-1])]
    rate = 1.0 / (time[1] - time[0])
    frequency, amplitude = spectra.amplitudes(samples / samples.mean(), rate)
    shown = frequency <= TO
    axes.plot(frequency[shown], 100.0 * amplitude[shown], color=colour, linewidth=0.9)
    for at, height in spectra.strongest(samples / samples.mean(), rate, 11):
        if at < TO:
            k, m = case_lines.nearest_order(lines, at)
            side = "+" if m > 0 else "−"
            axes.annotate(f"{k if k > 1 else ''}f{side}{abs(m) if abs(m) > 1 else ''}b", (at, 100.0 * height), xytext=(-2 if m > 0 else 2, 2),
                          textcoords="offset points", ha="left" if m > 0 else "right", va="bottom", fontsize=7)
    for at in case_lines.bedding_comb(lines, TO):
        axes.axvline(at, ymax=0.03, color=style.GREY, linewidth=0.5)
    axes.axvline(lines.crossing, color=style.GREY, linestyle=":")
    axes.set(ylabel=f"{words} over its mean (%)", xlim=(0.0, TO))


def draw(inputs):
    folder = inputs.only_folder()
    lines = case_lines.of_run(folder)
    figure, axes = style.panels(2, 1, (9.0, 6.0), sharex=True)
    for at, load in zip(axes, (("weight_on_bit", "WOB", style.BLUE), ("torque_on_bit", "TOB", style.RED))):
        draw_load(at, folder, lines, load)
    axes[0].set_title(f"f = {lines.rotation:.3g} Hz: rotation.  b = {lines.beds:.3g} Hz: pairs of beds that the bit passes.  "
                      f"Dotted, {lines.crossing:.3g} Hz: the gage crosses them on its way around")
    axes[1].set_xlabel("frequency (Hz)")
    return figure
