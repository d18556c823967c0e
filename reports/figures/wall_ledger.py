"""Ours: energy of a bit that bounces in an elastic hole, by the Runge-Kutta method and by a symplectic one."""

from figures import style

METHODS = {"symplectic_J": ("velocity Verlet, symplectic", style.BLUE),
           "runge_kutta_J": ("classical Runge-Kutta", style.RED)}
WHAT = "energy of a bouncing bit"


def draw(inputs):
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
