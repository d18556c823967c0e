"""Figure 5.2: what an applied torque does to a body with three spinning cones."""

from figures import results, style


def lines(axes, time, values, colours, label):
    for i, colour in enumerate(colours):
        axes.plot(time, values[:, i], color=colour, label=label.format("xyz"[i], i + 1))
    axes.legend(ncol=3, loc="best")


def draw(inputs):
    time, w_B, spin = results.history(inputs.folder("applied-torque"), "time", "angular_velocity",
                                      "cone_spin")
    figure, (body, cones) = style.panels(2, 1, (7.0, 5.2), sharex=True)
    lines(body, time, w_B, style.XYZ.values(), "$W_{0}$")
    lines(cones, time, spin, style.CONES[:spin.shape[1]], "cone {1}")
    body.set_ylabel("angular velocity, body frame (rad/s)")
    cones.set(ylabel="spin of the cones (rad/s)", xlabel="time (s)", xlim=(time[0], time[-1]))
    return figure
