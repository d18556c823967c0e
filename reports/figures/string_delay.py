"""Speed and torque of bit B at the surface and at the bit, while the bit sticks: what the bit does shows at the surface a travel time later."""

import math

import numpy as np

from figures import results, style

LENGTH, SHEAR, DENSITY = 2500.0, 79.3e9, 7850.0  # m, Pa, kg/m3: steel string of the case
TRAVEL = LENGTH / math.sqrt(SHEAR / DENSITY)  # s
RPM = 30.0 / math.pi
STILL = 0.02  # of the mean speed: the bit is at rest below
AROUND = 0.15  # s: means over this time, so that the cutters' chatter does not hide the waves


def smooth(time, values):
    """(time, moving means over AROUND), without the ends, where means lack a part of their time."""
    n = max(1, int(round(AROUND / (time[1] - time[0]))) | 1)
    return time[n // 2:len(time) - n // 2], np.convolve(values, np.ones(n) / n, mode="valid")


def events(time, speed):
    """Times at which the bit comes to rest and starts again."""
    still = speed < STILL * speed.mean()
    change = np.diff(still.astype(int))
    return time[1:][change == 1], time[1:][change == -1]


def draw(inputs):
    folder = inputs.folder("string-delay")
    time, speed, top, surface, torque = results.history(folder, "time", "rotary_speed", "top_speed", "surface_torque", "torque_on_bit")
    figure, (upper, lower) = style.panels(2, 1, (7.5, 5.2), sharex=True)
    upper.plot(time, RPM * top, color=style.BLUE, label="surface")
    upper.plot(time, RPM * speed, color=style.RED, label="bit")
    upper.set(ylabel="rotary speed (rpm)", ylim=(None, 1.25 * RPM * speed.max()))
    upper.legend(loc="upper right", ncols=2)
    lower.plot(time, 1e-3 * surface, color=style.BLUE, label="surface torque")
    lower.plot(*smooth(time, 1e-3 * torque), color=style.RED, label=f"torque on bit, means over {AROUND} s")
    lower.set(xlabel="time (s)", ylabel="torque (kN m)", xlim=(0.0, time[-1]))
    lower.legend(loc="upper right", ncols=2)
    lower.set_ylim(top=1.25 * 1e-3 * surface.max())
    for kind, colour in zip(events(time, speed), (style.BLACK, style.GREEN)):
        for t in kind:
            for axes in (upper, lower):
                axes.axvline(t, color=colour, linestyle=":", linewidth=1.0)
                axes.axvline(t + TRAVEL, color=colour, linestyle="--", linewidth=1.0)
    lower.set_title(f"bit stops (black) and starts (green): dotted; {TRAVEL:.3f} s later, 2500 m at {LENGTH / TRAVEL:.0f} m/s: dashed")
    return figure
