"""Figure 5.5: the path of the slow top's axis, seen along the vertical."""

from figures import results, style

PANELS = {"slow-top-thesis": ("thesis drift, reconstructed", style.RED),
          "slow-top-split": ("split drift", style.BLUE)}


def draw_path(axes, run, reference, label, colour):
    [exact] = results.history(reference, "axis_W")
    [axis] = results.history(run, "axis_W")
    step = results.summary(run)["step_s"]
    axes.plot(exact[:, 0], exact[:, 1], color=style.GREY, linewidth=2.6, alpha=0.45, label="reference, order 8")
    axes.plot(axis[:, 0], axis[:, 1], color=colour, linewidth=0.9, label=f"{label}, h = {step:g} s")
    axes.plot(*axis[0, :2], "o", color=style.BLACK, markersize=4)
    axes.set(aspect="equal", xlim=(-1.02, 1.02), ylim=(-1.02, 1.02), xlabel="$(R\\,e_3)_x$",
             ylabel="$(R\\,e_3)_y$")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.17))


def draw(inputs):
    figure, row = style.panels(1, 2, (8.0, 4.6), sharey=True)
    for axes, (group, (label, colour)) in zip(row, PANELS.items()):
        draw_path(axes, inputs.folder(group), inputs.folder("slow-top-reference"), label, colour)
    return figure
