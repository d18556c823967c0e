"""Figure 5.4: kinetic energy and angular momenta of the slow top, and what should not change."""

from figures import results, style

TRACES = {"slow-top-thesis": ("thesis drift, reconstructed", style.RED, (0, (4, 2))),
          "slow-top-split": ("split drift", style.BLUE, "solid")}


def draw_energy(axes, run, label, colour, dash):
    time, kinetic = results.history(run, "time", "kinetic_energy")
    axes.plot(time, kinetic, color=colour, linestyle=dash, label=label)


def draw_momenta(axes, run, label, dash):
    time, momentum = results.history(run, "time", "space_momentum")
    for i, (name, colour) in enumerate(style.XYZ.items()):
        axes.plot(time, momentum[:, i], color=colour, linestyle=dash,
                  label=f"$\\pi_{name}$" if dash == "solid" else None)


def draw_energy_error(axes, run, label, colour, dash):
    time, total = results.history(run, "time", "total_energy")
    axes.plot(time, (total - total[0]) / abs(total[0]), color=colour, linestyle=dash, label=label)


def draw_vertical_change(axes, run, label):
    """The number, since the line would be none: the vertical momentum keeps every bit."""
    [momentum] = results.history(run, "space_momentum")
    change = abs(momentum[:, 2] - momentum[0, 2]).max()
    return f"{label}: {change:.1e}" if change else f"{label}: exactly 0"


def draw(inputs):
    figure, (energy, momenta, error) = style.panels(3, 1, (7.0, 7.6), sharex=True)
    changes = []
    for group, (label, colour, dash) in TRACES.items():
        run = inputs.folder(group)
        draw_energy(energy, run, label, colour, dash)
        draw_momenta(momenta, run, label, dash)
        draw_energy_error(error, run, label, colour, dash)
        changes.append(draw_vertical_change(error, run, label))
    energy.set_ylabel("kinetic energy (J)")
    momenta.set_ylabel("angular momentum in space (N m s)")
    momenta.set_title("largest change of $\\pi_z$ (N m s): " + "; ".join(changes), fontsize=8)
    error.set(ylabel="total energy: relative change", xlabel="time (s)", xlim=(0.0, None))
    for axes in (energy, momenta, error):
        axes.legend(ncol=3, loc="upper right")
    return figure
