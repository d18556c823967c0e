"""Figure 5.5: the path of the slow top's axis, seen along the vertical; and its error."""

import numpy as np

from figures import results, style

TRACES = {"slow-top-thesis": ("thesis drift, reconstructed", style.RED, (0, (4, 2))),
          "slow-top-split": ("split drift", style.BLUE, "solid")}


def draw_path(axes, run, label, colour, dash):
    [axis] = results.history(run, "axis_W")
    axes.plot(axis[:, 0], axis[:, 1], color=colour, linestyle=dash, linewidth=1.1, label=label)


def draw_distance(axes, run, reference, label, colour, dash):
    """Between the axes at the same time; the reference has a row for each of the run's."""
    time, axis = results.history(run, "time", "axis_W")
    exact_time, exact = results.history(reference, "time", "axis_W")
    row = np.searchsorted(exact_time, time - 1e-9)
    assert np.allclose(exact_time[row], time), "the reference has other times"
    distance = np.linalg.norm(axis - exact[row], axis=1)
    axes.semilogy(time[1:], distance[1:], color=colour, linestyle=dash, label=label)


def draw(inputs):
    figure, (path, distance) = style.panels(1, 2, (9.4, 4.4))
    reference = inputs.folder("slow-top-reference")
    [exact] = results.history(reference, "axis_W")
    path.plot(exact[:, 0], exact[:, 1], color=style.GREY, linewidth=4, alpha=0.4, label="reference, order 8")
    for group, trace in TRACES.items():
        draw_path(path, inputs.folder(group), *trace)
        draw_distance(distance, inputs.folder(group), reference, *trace)
    path.plot(*exact[0, :2], "o", color=style.BLACK)
    step = results.summary(inputs.folder("slow-top-split"))["step_s"]
    path.set(aspect="equal", xlim=(-1.02, 1.02), ylim=(-1.02, 1.02), xlabel="$(R\\,e_3)_x$", ylabel="$(R\\,e_3)_y$",
             title=f"path of the axis, h = {step:g} s")
    path.legend(loc="lower right", fontsize=7)
    distance.set(xlabel="time (s)", ylabel="distance of $R\\,e_3$ from the reference", title="error of the axis")
    distance.legend(loc="lower right")
    return figure
