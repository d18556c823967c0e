"""Pictures of a folder of `tdbd rotate`: how the body turns, and what the integrator conserves."""

import numpy as np

from figures import results, style, traces

ROUNDING = 1e-11  # relative: a smaller change is rounding and is drawn as none
CONE_COLOURS = (style.PURPLE, style.GOLD, style.SKY, style.BLACK)


def components(axes, time, values, label, colours=tuple(style.XYZ.values())):
    """The components of a vector; constants as straight lines."""
    scale = np.abs(values).max(initial=0.0)
    for i in range(values.shape[1]):
        traces.draw(axes, time, values[:, i], colours[i % len(colours)], label.format("xyz"[i % 3], i + 1), scale, linewidth=1.1)
    if scale == 0.0:
        axes.set_ylim(-1.0, 1.0)
    else:
        axes.autoscale(True, axis="y")
        axes.margins(y=0.15)
        low, high = axes.get_ylim()
        if high - low < traces.MARGIN * scale:
            axes.set_ylim(*traces.span_around(0.5 * (low + high)))
    axes.margins(x=0.0)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))


def motion(folder, title):
    """Angular velocity, spins of the cones, and the third axis of the body in space."""
    time, w_B, axis, spins = results.history(folder, "time", "angular_velocity", "axis_W", "cone_spin")
    has_cones = spins.ndim == 2 and spins.shape[1] > 0
    rows = 3 if has_cones else 2
    figure, axes = style.panels(rows, 1, (7.4, 1.0 + 2.0 * rows), sharex=True)
    components(axes[0], time, w_B, "$\\omega_{0}$")
    axes[0].set_ylabel("angular velocity,\nbody frame (rad/s)")
    if has_cones:
        components(axes[1], time, spins, "cone {1}", CONE_COLOURS)
        axes[1].set_ylabel("spin of the\ncones (rad/s)")
    components(axes[-1], time, axis, "$(R e_3)_{0}$")
    axes[-1].set(ylabel="third axis of the\nbody, in space", xlabel="time (s)")
    figure.suptitle(traces.fitted(title, figure), fontsize=10)
    return figure


def path(folder, title):
    """The path of the third axis of the body, seen along the vertical."""
    [axis] = results.history(folder, "axis_W")
    figure, axes = style.panels(1, 1, (5.2, 5.0))
    axes.add_patch(style.circle(1.0))
    axes.plot(axis[:, 0], axis[:, 1], color=style.BLUE, linewidth=0.9)
    axes.plot(*axis[0, :2], "o", color=style.BLACK, label="start")
    axes.plot(*axis[-1, :2], "s", color=style.RED, label="end")
    axes.set(aspect="equal", xlim=(-1.05, 1.05), ylim=(-1.05, 1.05), xlabel="$(R e_3)_x$", ylabel="$(R e_3)_y$")
    axes.legend(loc="upper right", fontsize=7)
    figure.suptitle(traces.fitted(f"Path of the third axis of the body\n{title}", figure), fontsize=10)
    return figure


def draw_change(axes, time, change, colour, words):
    """A relative change; rounding as a line at 0, with its size in words."""
    largest = np.abs(change).max()
    if largest <= ROUNDING:
        axes.plot(time, np.zeros_like(change), color=colour)
        axes.set_ylim(-1.0, 1.0)
        axes.set_yticks([0.0])
        note = "no change" if largest == 0.0 else f"rounding only: at most {largest:.1e}"
        axes.text(0.5, 0.62, note, transform=axes.transAxes, ha="center", color=style.GREY)
    else:
        axes.plot(time, change, color=colour, linewidth=0.9)
    axes.set_ylabel(words)
    axes.margins(x=0.0)


def conservation(folder, title):
    """Energies, and the changes of total energy and vertical momentum, which the exact motion conserves."""
    time, kinetic, potential, total, momentum = results.history(folder, "time", "kinetic_energy", "potential_energy", "total_energy",
                                                                "space_momentum")
    scale = results.summary(folder).get("energy_scale") or np.abs(total).max() or 1.0
    figure, axes = style.panels(3, 1, (7.4, 6.6), sharex=True)
    for values, words, colour in ((kinetic, "kinetic", style.BLUE), (potential, "potential", style.GOLD), (total, "total", style.BLACK)):
        traces.draw(axes[0], time, values, colour, words, scale, linewidth=1.1)
    axes[0].autoscale(True, axis="y")
    axes[0].margins(x=0.0, y=0.15)
    axes[0].set_ylabel("energy (J)")
    axes[0].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    draw_change(axes[1], time, (total - total[0]) / scale, style.BLACK, "change of the total\nenergy over its scale")
    size = np.linalg.norm(momentum[0]) or 1.0
    draw_change(axes[2], time, (momentum[:, 2] - momentum[0, 2]) / size, style.GREEN, "change of the vertical\nmomentum over its size")
    axes[2].set_xlabel("time (s)")
    figure.suptitle(traces.fitted(title, figure), fontsize=10)
    return figure
