"""Bits that drill: traces and spectra of loads, forces by cutter, whirl, and the noise of the mesh."""

import numpy as np

from figures import bit_data, results, signals, style, traces

def drilling_traces(inputs):
    """Weight, torque and speeds of bits that drill by themselves, and the spectra of what varies."""
    figure, axes = style.panels(4, 2, (9.6, 8.4))
    for column, (run, name) in enumerate((("stick-slip", "Long string: stick-slip"), ("bounce", "Bit R in granite: bounce"))):
        folder = inputs.folder(run)
        for at, panel in zip(axes[:, column], traces.PANELS):
            traces.draw_panel(at, folder, panel)
        traces.draw_spectra(axes[3, column], folder, traces.expected(folder))
        axes[0, column].set_title(name)
        axes[2, column].set_xlabel("time (s)")
    return figure


START_UP = 2.0  # s
TO = 45.0  # Hz


def draw_load(axes, folder, lines, load):
    name, words, colour = load
    time, samples = results.history(folder, "time", name)
    samples = samples[time > min(START_UP, 0.2 * time[-1])]
    rate = 1.0 / (time[1] - time[0])
    frequency, amplitude = signals.amplitudes(samples / samples.mean(), rate)
    shown = frequency <= TO
    axes.plot(frequency[shown], 100.0 * amplitude[shown], color=colour, linewidth=0.9)
    for at, height in signals.strongest(samples / samples.mean(), rate, 11):
        if at < TO:
            k, m = signals.nearest_order(lines, at)
            side = "+" if m > 0 else "−"
            axes.annotate(f"{k if k > 1 else ''}f{side}{abs(m) if abs(m) > 1 else ''}b", (at, 100.0 * height), xytext=(-2 if m > 0 else 2, 2),
                          textcoords="offset points", ha="left" if m > 0 else "right", va="bottom", fontsize=7)
    for at in signals.bedding_comb(lines, TO):
        axes.axvline(at, ymax=0.03, color=style.GREY, linewidth=0.5)
    axes.axvline(lines.crossing, color=style.GREY, linestyle=":")
    axes.set(ylabel=f"{words} over its mean (%)", xlim=(0.0, TO))


def bedding_lines(inputs):
    """The lines that dipping beds make in weight and torque, and where rotation and advance put them."""
    folder = inputs.only_folder()
    lines = signals.lines_of_run(folder)
    figure, axes = style.panels(2, 1, (9.0, 6.0), sharex=True)
    for at, load in zip(axes, (("weight_on_bit", "WOB", style.BLUE), ("torque_on_bit", "TOB", style.RED))):
        draw_load(at, folder, lines, load)
    axes[0].set_title(f"f = {lines.rotation:.3g} Hz: rotation.  b = {lines.beds:.3g} Hz: pairs of beds that the bit passes.  "
                      f"Dotted, {lines.crossing:.3g} Hz: the gage crosses them on its way around")
    axes[1].set_xlabel("frequency (Hz)")
    return figure


RATE, UP, DOWN = 1000.0, 64, 125
LOW = RATE * UP / DOWN  # Hz
COLUMNS_OF_HIGH_FREQUENCY = (("high-frequency", "Rock that is the same everywhere"),
           ("high-frequency-beds", "Beds of 65 and 85 MPa, 8 mm thick, that dip by 30 degrees"))
LOADS = (("weight_on_bit", "WOB", style.BLUE), ("torque_on_bit", "TOB", style.RED))


def loads(folder):
    """Time (s) from the end of the start-up, then weight and torque."""
    time, *values = results.history(folder, "time", *(name for name, *_ in LOADS))
    late = time > min(START_UP, 0.2 * time[-1])
    return time[late] - time[late][0], [v[late] for v in values]


def draw_load_traces(axes, time, values):
    """Two seconds."""
    for samples, (_, name, colour) in zip(values, LOADS):
        shown = time <= 2.0
        axes.plot(time[shown], 100.0 * (samples[shown] / samples.mean() - 1.0), color=colour, linewidth=0.8, label=name)
    axes.set(xlabel="time (s)", ylabel="WOB, TOB: off the mean (%)")


def draw_both_rates(axes, time, values):
    """Half a second of both rates."""
    for samples, (_, name, colour) in zip(values, LOADS):
        mean = samples.mean()
        low = signals.resampled(samples, UP, DOWN)
        low_time = np.arange(len(low)) / LOW
        shown, low_shown = (time >= 1.0) & (time <= 1.5), (low_time >= 1.0) & (low_time <= 1.5)
        axes.plot(time[shown], 100.0 * (samples[shown] / mean - 1.0), color=colour, linewidth=0.6,
                  label=f"{name}, 1000 Hz")
        axes.plot(low_time[low_shown], 100.0 * (low[low_shown] / mean - 1.0), ".", color=colour, markersize=2.5,
                  label=f"{name}, 512 Hz")
    axes.set(xlabel="time (s)", ylabel="off the mean (%)")


def draw_spectra(axes, values, lines):
    for samples, (_, name, colour) in zip(values, LOADS):
        for series, rate, width in ((samples, RATE, 0.8), (signals.resampled(samples, UP, DOWN), LOW, 2.4)):
            frequency, density = signals.welch(series / samples.mean(), rate)
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
        for make, shape, how in ((signals.resampled, "-", "with the low pass"), (signals.interpolated, ":", "straight between readings")):
            frequency, ratio = signals.ratios(make(samples, UP, DOWN), LOW, samples, RATE)
            axes.semilogy(frequency, ratio, shape, color=colour, linewidth=0.9, label=f"{name} {how}")
    axes.set(xlabel="frequency (Hz)", ylabel="density at 512 Hz\nover that at 1000 Hz", xlim=(0.0, signals.BAND[1]), ylim=(0.4, 10.0))


def high_frequency(inputs):
    """Weight and torque at 1000 Hz and brought to 512 Hz: traces and spectra, homogeneous rock beside dipping beds."""
    figure, axes = style.panels(4, 2, (10.0, 11.5), sharey="row", height_ratios=(1.0, 1.0, 1.7, 0.8))
    for column, (run, title) in zip(axes.T, COLUMNS_OF_HIGH_FREQUENCY):
        folder = inputs.folder(run)
        time, values = loads(folder)
        draw_load_traces(column[0], time, values)
        spread = ", ".join(f"{name} {100.0 * v.std() / v.mean():.2g} %" for v, (_, name, _) in zip(values, LOADS))
        column[0].set_title(f"{title}\nrms over mean: {spread}")
        draw_both_rates(column[1], time, values)
        draw_spectra(column[2], values, signals.lines_of_run(folder))
        draw_ratios(column[3], values)
    for right in axes[:, 1]:
        right.set_ylabel("")
    axes[0, 0].legend(loc="upper right", ncols=2)
    axes[1, 0].legend(loc="upper right", ncols=2, fontsize=7)
    axes[3, 0].legend(loc="upper left", ncols=2, fontsize=7)
    return figure


def of_parts(summary, kind):
    """{cutter number: part figures} of the parts of a kind."""
    found = {}
    for part in summary["forces"]:
        cutter, _, what = part["name"].partition("/")
        if what == kind and cutter.startswith("cutter-"):
            found[int(cutter.removeprefix("cutter-"))] = part
    return found


def bars(axes, numbers, parts, key, scale, style_of):
    label, colour, bottom = style_of
    heights = np.array([scale * parts[n][key] if n in parts else 0.0 for n in numbers])
    axes.bar(numbers, heights, bottom=bottom, color=colour, label=label, width=0.8)
    return heights


def forces_by_cutter(inputs):
    """Forces of every cutter in steady drilling: faces, chamfers, power."""
    return draw_summary(results.summary(inputs.folder("forces-b")))


def draw_summary(summary):
    """Of any run with forces of a bit with cutters."""
    faces, chamfers = of_parts(summary, "face"), of_parts(summary, "chamfer")
    numbers = np.array(sorted(faces | chamfers))
    figure, axes = style.panels(3, 1, (7.0, 6.4), sharex=True)
    for panel, key, scale, label in ((axes[0], "normal_mean_n", 1e-3, "normal force (kN)"),
                                     (axes[1], "tangential_mean_n", 1e-3, "tangential force (kN)"),
                                     (axes[2], "power_mean_w", 1e-3, "power (kW)")):
        below = bars(panel, numbers, faces, key, scale, ("face", style.BLUE, 0.0))
        bars(panel, numbers, chamfers, key, scale, ("chamfer", style.GOLD, below))
        panel.set_ylabel(label)
    axes[0].legend(loc="upper right")
    axes[2].set_xlabel("cutter, from the axis outwards")
    return figure


def rotations(vectors):
    """(n, 3, 3) of rotation vectors (n, 3), rad."""
    angle = np.linalg.norm(vectors, axis=1)
    axis = vectors / np.maximum(angle, 1e-300)[:, None]
    x, y, z = axis.T
    zero = np.zeros_like(x)
    skew = np.stack([np.stack([zero, -z, y], 1), np.stack([z, zero, -x], 1), np.stack([-y, x, zero], 1)], 1)
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sine * skew + (1 - cosine) * skew @ skew


def centre_of_mass(folder, centre_B):
    """(time, place): s and m, (n,) and (n, 3), of a run's history."""
    time, *columns = results.history(folder, "time", *(f"position_{k}" for k in "xyz"),
                                     *(f"rotation_vector_{k}" for k in "xyz"))
    place, vectors = np.stack(columns[:3], axis=1), np.stack(columns[3:], axis=1)
    return time, place + rotations(vectors) @ np.asarray(centre_B)


def whirl_path(inputs):
    """Figure 4.36: where the centre of mass goes while the bit whirls."""
    run, bit = inputs.folder("whirl-b"), bit_data.read(inputs.folder("bit-b"))
    time, place = centre_of_mass(run, bit.analysis["centre_m"])
    ramp = results.summary(run)["duration_s"] / results.summary(run)["revolutions"]
    figure, axes = style.panels(1, 1, (5.2, 5.0))
    early = time <= ramp
    axes.plot(*(1e3 * place[early, :2].T), color=style.SKY, label="first revolution, while the whirl grows")
    axes.plot(*(1e3 * place[~early, :2].T), color=style.BLUE, label="later revolutions")
    axes.plot(*(1e3 * place[0, :2]), "o", color=style.RED, label="start")
    reach = 1.35e3 * np.abs(place[:, :2]).max()
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    axes.legend(loc="upper left")
    return figure


def rolling_whirl(inputs):
    """A bit that rolls backward in its hole: orbit of the centre, its phase, its frequency beside that of pure rolling."""
    folder = inputs.folder("rolling-whirl")
    time, x, y = results.history(folder, "time", "position_x", "position_y")
    diagnosis = results.summary(folder)["diagnosis"]
    figure, (orbit, phase) = style.panels(1, 2, (9.0, 4.2))
    late = time > 0.5 * time[-1]
    orbit.plot(1e3 * x[~late], 1e3 * y[~late], color=style.SKY, linewidth=0.6, label="first half of the run")
    orbit.plot(1e3 * x[late], 1e3 * y[late], color=style.BLUE, linewidth=0.8, label="second half")
    orbit.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)", title="centre of the bit")
    orbit.legend(loc="upper right")
    turns = np.unwrap(np.arctan2(y, x)) / (2.0 * np.pi)
    phase.plot(time, turns, color=style.BLUE, label="centre")
    rolling = diagnosis["rolling_frequency_at_orbit_hz"]
    start = turns[late][0]
    phase.plot(time[late], start + rolling * (time[late] - time[late][0]), color=style.RED, linestyle="--",
               label=f"pure rolling at the orbit's radius, {rolling:.1f} Hz")
    phase.set(xlabel="time (s)", ylabel="turns of the centre about the hole's axis",
              title=f"measured {diagnosis['orbit_frequency_hz']:.1f} Hz")
    phase.legend(loc="upper right")
    return figure


def backward_travel(inputs):
    """Share of time in which cutters move backward and sideways in whirl, over their radius."""
    rows = inputs.table("whirl-motion")
    if rows is None:
        return style.only_words("Backward travel")
    figure, axes = style.panels(1, 1, (6.4, 3.8))
    r = [row["r_over_gage"] for row in rows]
    line = np.linspace(0.0, 1.0, 401)
    axes.plot(line, np.arccos(line) / np.pi, color=style.GREY, label="arccos(r/R)/$\\pi$")
    axes.plot(r, [row["backward"] for row in rows], "o", color=style.RED, label="backward")
    axes.plot(r, [row["sideways"] for row in rows], "s", color=style.BLUE, label="sideways rather than along")
    axes.set(xlabel="radius of the cutter over that of the bit", ylabel="share of time", xlim=(0.0, 1.02), ylim=(0.0, 0.6))
    axes.legend(loc="lower left")
    return figure


METHODS = {"symplectic_J": ("velocity Verlet, symplectic", style.BLUE),
           "runge_kutta_J": ("classical Runge-Kutta", style.RED)}
WHAT = "energy of a bouncing bit"


def wall_ledger(inputs):
    """Addition of TDBD: energy of a bit that bounces in an elastic hole, by the Runge-Kutta method and by a symplectic one."""
    rows = inputs.table("wall-ledger")
    if not rows:
        return style.only_words(WHAT)
    figure, axes = style.panels(1, 1, (7.0, 3.6))
    time = [row["t_s"] for row in rows]
    for key, (label, colour) in METHODS.items():
        share = [100.0 * row[key] / rows[0][key] for row in rows]
        axes.plot(time, share, color=colour, label=f"{label}: {share[-1]:.0f} % after {time[-1]:g} s")
    axes.axhline(100.0, color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 2)), zorder=3, label="exact: no energy is lost")
    axes.set(xlabel="time (s)", ylabel="energy (% of the first)", ylim=(0.0, 110.0))
    axes.margins(x=0.0)
    axes.legend(loc="lower left")
    return figure


CUTTERS = {"graded": (style.BLUE, "o"), "even 2 mm": (style.RED, "s"), "even 4 mm": (style.GREEN, "^")}
FORCES = {"volume": "-", "section": ":"}


def draw_noise(axes, rows):
    for (cutters, (colour, marker)), (forces, line) in ((c, f) for f in FORCES.items() for c in CUTTERS.items()):
        shown = [r for r in rows if r["motion"] == "given rate" and r["cutters"] == cutters and r["forces"] == forces]
        axes.loglog([1e3 * r["rock_edge_m"] for r in shown], [100.0 * r["noise"] for r in shown], line, color=colour, marker=marker,
                    markersize=6 if cutters == "graded" else 4, fillstyle="none" if cutters == "graded" else "full",
                    label=f"{forces}s, cutters {cutters}")
    edges = np.array([1.0, 4.0])
    axes.loglog(edges, 3.0 * edges**1.8, "--", color=style.GREY, label="power 1.8")
    axes.set(title="At a given rate", xlabel="edge of the rock's mesh (mm)", ylabel="torque: rms about its mean, over it (%)",
             ylim=(0.05, 200.0))
    axes.set_xticks([1.0, 1.4, 2.0, 2.8, 4.0], ["1", "1.4", "2", "2.8", "4"])
    axes.set_yticks([0.1, 1.0, 10.0, 100.0], ["0.1", "1", "10", "100"])
    axes.minorticks_off()
    axes.legend(fontsize=7, ncols=2, loc="upper left")


def draw_noise_traces(axes, traces):
    for trace in traces:
        torque = 1e-3 * np.array(trace["torque_n_m"])
        colour, _ = CUTTERS[trace["cutters"]]
        axes.plot(1e3 * trace["step_s"] * np.arange(len(torque)), torque, color=colour, linewidth=0.8,
                  label=trace["cutters"] if trace["forces"] == "volume" else None)
    axes.set(xlabel="time (ms)", ylabel="torque (kN m)")


def mesh_noise(inputs):
    """Noise of bit A's torque over the edge of the rock's mesh, and its traces, with cutters meshed in three ways."""
    rows, traces = inputs.table("mesh-noise"), inputs.table("mesh-noise-traces")
    if rows is None or traces is None:
        return style.only_words("Noise of meshes")
    figure = style.Figure(figsize=(10.0, 5.2), layout="constrained")
    left, right = figure.subfigures(1, 2, width_ratios=(1.0, 1.1))
    draw_noise(left.subplots(), rows)
    axes = right.subplots(2, 1, sharex=True)
    for at, forces in zip(axes, FORCES):
        draw_noise_traces(at, [t for t in traces if t["forces"] == forces])
        at.set_title(f"Moved by forces, from {forces}s; rock of 2 mm")
    axes[0].set(xlabel="", ylim=(1.1, 3.3))
    axes[0].legend(title="cutters", ncols=3, loc="upper right", fontsize=7, title_fontsize=7)
    return figure
