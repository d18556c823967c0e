"""A bit that rolls backward in its hole: orbit of the centre, its phase, its frequency beside that of pure rolling."""

import numpy as np

from figures import results, style


def draw(inputs):
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
