"""Figure 2.1: spokes and our mesh at the gage; distances of points and errors from the axis to the gage."""

from matplotlib.collections import PolyCollection

from figures import style

# key of the tables: (label, colour, marker)
ROCKS = {"mesh": ("our mesh", style.BLUE, "o"), "spoke": ("Langeveld", style.RED, "^"), "outline": ("Hanson and Hansen", style.GREEN, "s")}
GAGE = 107.95  # mm


def draw_window(axes, rows, kind):
    """What stands at the gage, from above."""
    shown = [row["points_mm"] for row in rows if row["of"] == kind]
    _, colour, _ = ROCKS[kind]
    if kind == "mesh":
        axes.add_collection(PolyCollection(shown, facecolor="none", edgecolor=colour, linewidth=0.8))
    else:
        for nodes in shown:
            x, y = zip(*nodes)
            axes.plot(x, y, "-", color=style.BLACK, linewidth=0.8)
            axes.plot(x, y, ".", color=colour, markersize=5)
    axes.add_patch(style.circle(GAGE))
    axes.set(aspect="equal", xlim=(97.0, 108.5), ylim=(-6.2, 6.2), xlabel="x (mm)", ylabel="y (mm)")
    axes.grid(False)


def draw_over_radius(axes, rows, key, kinds, line="-", note="", fill="full"):
    for kind in kinds:
        label, colour, marker = ROCKS[kind]
        axes.plot([r["r_mm"] for r in rows], [r[f"{kind}_{key}"] for r in rows], line, color=colour, marker=marker,
                  fillstyle=fill, label=label + note)
    axes.set(xlabel="radius (mm)", xlim=(0.0, 110.0))


def draw(inputs):
    window, steady, whirl, many = map(inputs.table, ("spokes-gage", "spokes-steady", "spokes-whirl", "spokes-whirl-240"))
    if None in (window, steady, whirl, many):
        return style.only_words("Spokes beside the mesh")
    figure, axes = style.panels(2, 3, (10.2, 7.4))
    draw_window(axes[0, 0], window, "spoke")
    axes[0, 0].set_title("120 spokes, 228 nodes each")
    draw_window(axes[0, 1], window, "mesh")
    axes[0, 1].set_title("Our mesh of as many points")
    spacing, still, moved, doubled = axes[0, 2], *axes[1]
    draw_over_radius(spacing, steady, "spacing_mm", ("mesh", "spoke"))
    spacing.plot([r["r_mm"] for r in steady], [r["node_spacing_mm"] for r in steady], ":", color=style.RED, label="nodes of a spoke")
    spacing.set(title="Distance of neighbours", ylabel="mm", ylim=(0.0, 6.0))
    spacing.legend(loc="upper left")
    for at, rows, title in ((still, steady, "Steady, 120 spokes"), (moved, whirl, "Backward whirl, 120 spokes"),
                            (doubled, many, "Backward whirl, 240 spokes")):
        draw_over_radius(at, rows, "error_mm", ROCKS)
        at.set(title=title, ylabel="mean error (mm)", ylim=(0.0, 0.085))
    still.legend(loc="upper left")
    return figure
