"""Figure 4.36: where the centre of mass goes while the bit whirls."""

import numpy as np

from figures import bit_data, results, style


def rotations(vectors):
    """(n, 3, 3) of rotation vectors (n, 3), rad."""
    angle = np.linalg.norm(vectors, axis=1)
    axis = vectors / np.maximum(angle, 1e-300)[:, None]
    x, y, z = axis.T
    zero = np.zeros_like(x)
    skew = np.stack([np.stack([zero, -z, y], 1), np.stack([z, zero, -x], 1), np.stack([-y, x, zero], 1)], 1)
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sine * skew + (1 - cosine) * skew @ skew


def centre_of_mass(folder, centre_B):
    """(time, place): s and m, (n,) and (n, 3), of a run's history."""
    time, *columns = results.history(folder, "time", *(f"position_{k}" for k in "xyz"),
                                     *(f"rotation_vector_{k}" for k in "xyz"))
    place, vectors = np.stack(columns[:3], axis=1), np.stack(columns[3:], axis=1)
    return time, place + rotations(vectors) @ np.asarray(centre_B)


def draw(inputs):
    run, bit = inputs.folder("whirl-b"), bit_data.read(inputs.folder("bit-b"))
    time, place = centre_of_mass(run, bit.analysis["centre_m"])
    ramp = results.summary(run)["duration_s"] / results.summary(run)["revolutions"]
    figure, axes = style.panels(1, 1, (5.2, 5.0))
    early = time <= ramp
    axes.plot(*(1e3 * place[early, :2].T), color=style.SKY, label="first revolution, while the whirl grows")
    axes.plot(*(1e3 * place[~early, :2].T), color=style.BLUE, label="later revolutions")
    axes.plot(*(1e3 * place[0, :2]), "o", color=style.RED, label="start")
    reach = 1.35e3 * np.abs(place[:, :2]).max()
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    axes.legend(loc="upper left")
    return figure
