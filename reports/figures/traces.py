"""Traces of a run over time, one quantity to a panel, and their spectra. Constants are drawn as constants."""

import textwrap

import netCDF4
import numpy as np

from figures import results, style

SAME = 1e-6  # a trace that varies by less, relative to its size, is a constant with rounding errors
MARGIN = 0.1  # of a constant's size, above and below it
RPM = 30.0 / np.pi
# name in history.nc, label, factor, colour
PANELS = (("weight_on_bit", "weight on bit (kN)", 1e-3, style.BLUE), ("torque_on_bit", "torque on bit (kN m)", 1e-3, style.RED),
          ("rotary_speed", "speed of the bit (rpm)", RPM, style.GREEN))
RATE = ("rate_of_penetration", "rate of penetration (m/h)", 3600.0, style.PURPLE)
WITHOUT_FORCES = (("position_z", "depth of the bit (mm)", 1e3, style.BLUE),
                  ("removed_volume_total", "rock removed (cm$^3$)", 1e6, style.RED))
CHARACTERS_PER_INCH = 12.5  # of a title


def fitted(text, figure, share=1.0):
    """A title, wrapped to the width of its figure, or to a share of it."""
    width = max(24, int(CHARACTERS_PER_INCH * share * figure.get_figwidth()))
    return "\n".join(textwrap.fill(line, width) for line in text.split("\n"))


def constant(values, scale=0.0):
    """The value that a trace has all the time, or None. `scale`: a size below which a change is rounding, times SAME."""
    known = np.asarray(values, dtype=float)
    known = known[np.isfinite(known)]
    if not known.size:
        return None
    middle = 0.5 * (known.min() + known.max())
    return float(f"{middle:.6g}") if np.ptp(known) <= SAME * max(np.abs(known).max(), scale) else None


def span_around(value):
    """Limits of an axis that shows a constant as a line in its middle."""
    half = MARGIN * abs(value) if value else 1.0
    return value - half, value + half


def draw(axes, time, values, colour, label=None, scale=0.0, **options):
    """A trace; a constant as a straight line in the middle of its axis, unless the axis has other traces."""
    value = constant(values, scale)
    is_first = not axes.lines
    axes.plot(time, np.full(len(time), value) if value is not None else values, color=colour, label=label,
              **{"linewidth": 0.8, **options})
    if value is not None and is_first:
        axes.set_ylim(*span_around(value))
    elif value is None and not axes.get_autoscaley_on():
        axes.autoscale(True, axis="y")


def variables(folder):
    """The names of the variables over time in history.nc."""
    with netCDF4.Dataset(folder / "history.nc") as data:
        return {name for name, variable in data.variables.items() if variable.dimensions == ("time",)}


def panels_of(folder):
    """The panels for which the history has a variable: loads and speed of a run with forces, otherwise depth and volume."""
    found = variables(folder)
    chosen = [p for p in PANELS if p[0] in found]
    if any(p[0] == "weight_on_bit" for p in chosen):
        drives = results.summary(folder).get("diagnosis") is not None
        return chosen + ([RATE] if drives and RATE[0] in found else [])
    return [p for p in (*WITHOUT_FORCES, PANELS[2]) if p[0] in found]


def draw_panel(axes, folder, panel):
    """A trace; where a row is the mean of several steps, the range of the steps behind it."""
    name, label, factor, colour = panel
    found = variables(folder)
    time, values = results.history(folder, "time", name)
    if f"{name}_min" in found and constant(values) is None:
        low, high = results.history(folder, f"{name}_min", f"{name}_max")
        axes.fill_between(time, factor * low, factor * high, color=colour, alpha=0.2, linewidth=0, label="range of the steps")
        axes.legend(loc="upper right", fontsize=7)
    draw(axes, time, factor * values, colour)
    axes.set_ylabel(label)
    axes.margins(x=0.0)


def spectrum(time, samples):
    """(frequency, amplitude) under a Hann window: Hz, and the samples' unit."""
    window = np.hanning(len(samples))
    lines = np.fft.rfft((samples - samples.mean()) * window) * 2.0 / window.sum()
    return np.fft.rfftfreq(len(samples), time[1] - time[0]), np.abs(lines)


def marked(axes, marks):
    """Named frequencies as dotted lines; names that would overlap share a place."""
    groups = []
    for frequency, name in sorted(marks):
        if groups and frequency < 1.25 * groups[-1][0]:
            groups[-1][1].append(name)
        else:
            groups.append((frequency, [name]))
        axes.axvline(frequency, color=style.GREY, linestyle=":", linewidth=1.0)
    for frequency, names in groups:
        axes.text(frequency, 0.98, f" {', '.join(names)}", transform=axes.get_xaxis_transform(), rotation=90, ha="right", va="top",
                  fontsize=7, color=style.BLACK)


def draw_spectra(axes, folder, marks):
    """Amplitudes in the second half of a run, of what varies there; a remark if nothing does."""
    named = [p for p in PANELS if p[0] in variables(folder)]
    time, *traces = results.history(folder, "time", *(p[0] for p in named))
    late = time > 0.5 * time[-1]
    drawn = 0
    for samples, (_, label, factor, colour) in zip(traces, named):
        if late.sum() < 8 or constant(samples[late]) is not None:
            continue
        frequency, amplitude = spectrum(time[late], factor * samples[late])
        axes.loglog(frequency[1:], np.maximum(amplitude[1:], 1e-9 * amplitude.max()), color=colour, linewidth=0.7, label=label)
        drawn += 1
    if not drawn:
        axes.set(xticks=[], yticks=[])
        axes.text(0.5, 0.5, "no spectrum: all traces are constant, or shorter than eight rows", transform=axes.transAxes,
                  ha="center", va="center", color=style.GREY)
        return
    marked(axes, marks)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=drawn, fontsize=7, borderaxespad=0.2)
    axes.set(xlabel="frequency (Hz), second half of the run", ylabel="amplitude")


def expected(folder):
    """[(Hz, name)] of frequencies that string and mass would show by themselves, and of the rotation."""
    summary = results.summary(folder)
    diagnosis = summary.get("diagnosis") or {}
    found = [(diagnosis.get(f"{mode}_frequency_expected_hz") or 0.0, mode) for mode in ("torsional", "axial")]
    speed = summary.get("rotary_speed_mean_rad_per_s") or 0.0
    return [(f, name) for f, name in [*found, (abs(speed) / (2.0 * np.pi), "rotation")] if f > 0.0]


def draw_folder(folder, title):
    """The traces of any run, with spectra of a run with forces."""
    panels = panels_of(folder)
    has_spectra = any(p[0] == "weight_on_bit" for p in panels)
    rows = len(panels) + has_spectra
    figure, axes = style.panels(rows, 1, (7.0, 1.3 + 1.65 * rows), squeeze=False)
    for at, panel in zip(axes[:, 0], panels):
        draw_panel(at, folder, panel)
    axes[len(panels) - 1, 0].set_xlabel("time (s)")
    for at in axes[:len(panels) - 1, 0]:
        at.tick_params(labelbottom=False)
    if has_spectra:
        draw_spectra(axes[-1, 0], folder, expected(folder))
    figure.suptitle(fitted(title, figure), fontsize=10)
    return figure
