"""Figure 5.4: kinetic energy and angular momenta of the slow top, and what should not change."""

from figures import results, style

TRACES = {"slow-top-thesis": ("thesis drift, reconstructed", style.RED, (0, (4, 2))),
          "slow-top-split": ("split drift", style.BLUE, "solid")}


def draw_energies(energy, error, run, label, colour, dash):
    time, kinetic, total = results.history(run, "time", "kinetic_energy", "total_energy")
    energy.plot(time, kinetic, color=colour, linestyle=dash, label=label)
    error.plot(time, 100.0 * (total - total[0]) / abs(total[0]), color=colour, linestyle=dash, label=label)


def draw_momenta(axes, run, dash):
    time, momentum = results.history(run, "time", "space_momentum")
    for i, (name, colour) in enumerate(style.XYZ.items()):
        axes.plot(time, momentum[:, i], color=colour, linestyle=dash,
                  label=f"$\\pi_{name}$" if dash == "solid" else None)


def vertical_change(run):
    """In words: the vertical momentum keeps every bit, which no line can show."""
    [momentum] = results.history(run, "space_momentum")
    change = abs(momentum[:, 2] - momentum[0, 2]).max()
    return f"{change:.1e} N m s" if change else "exactly 0"


def draw(inputs):
    figure, (energy, momenta, error) = style.panels(3, 1, (7.0, 7.6), sharex=True)
    changes = []
    for group, (label, colour, dash) in TRACES.items():
        run = inputs.folder(group)
        draw_energies(energy, error, run, label, colour, dash)
        draw_momenta(momenta, run, dash)
        changes.append(f"{label}: {vertical_change(run)}")
    energy.set_ylabel("kinetic energy (J)")
    momenta.set(ylabel="angular momentum\nin space (N m s)", title="largest change of $\\pi_z$: " + "; ".join(changes))
    error.set(ylabel="change of the total energy (%)", xlabel="time (s)")
    for axes, place in ((energy, "upper center"), (momenta, "lower left"), (error, "lower center")):
        axes.legend(loc=place)
        axes.margins(x=0.0)
    return figure
