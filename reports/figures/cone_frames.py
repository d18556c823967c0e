"""Figure 5.1: the coordinate systems of a roller cone bit: space, bit, and a cone with its axis."""

import numpy as np

from figures import bit_data, bit_scene, render, style

INCHES = (4.9, 4.0)
VIEW = {"toward": (0.85, -0.35, 0.32), "up": (0, 0, -1)}
SPIN = {"s": "#c8322b", "d": "#2462c2", "t": "#2f9e44"}  # of a cone: axis, and two directions that turn with it
FRAMES = 10**6  # owners of arrows begin here


def spin_axes(cone):
    """s along the journal; d normal to it, in the upright plane through it; t = s x d."""
    s = render.unit(cone["axis"])
    d = render.unit(np.array([0.0, 0.0, -1.0]) + s[2] * s)
    return {"s": s, "d": d, "t": np.cross(s, d)}


def cone_place(bit, k):
    """The middle of a cone's body, on its axis."""
    cone = bit.cones[k]
    body = next(i for i, p in enumerate(bit.parts) if p["kind"] == "cone" and p["cone"] == k)
    origin, s = np.array(cone["origin_m"]), render.unit(cone["axis"])
    return origin + np.dot(bit.centres[body] - origin, s) * s


def triad(axes, start, length, colours, owner):
    return [bit_scene.arrows([start], [direction], length, colours[name], 0.03 * length, owner + k)
            for k, (name, direction) in enumerate(axes.items())]


def label(place, camera, point, text, colour):
    x, y = camera.place(point)
    place.text(x, y, text, color=colour, fontsize=11, weight="bold", ha="center", va="center")


def label_triad(place, camera, axes, start, length, colours, suffix=""):
    for name, direction in axes.items():
        label(place, camera, start + 1.13 * length * direction, name + suffix, colours[name])


def widened(camera, by, shift=(0.0, 0.0, 0.0)):
    return render.Camera(camera.toward, camera.up, tuple(np.array(camera.centre) + shift), by * camera.width, camera.pixels)


def draw_whole(place, bit, dpi):
    """Space and bit with the same axes, c between their origins, and the three axes of the cones."""
    radius = bit.analysis["gage_radius_m"]
    unit = dict(zip("xyz", np.eye(3)))
    centre, space = np.array(bit.analysis["centre_m"]), np.array([0.0, 1.8, -2.3]) * radius
    camera = widened(bit_scene.camera(bit, VIEW, INCHES, dpi), 1.32, (0.0, 0.42 * radius, 0.0))
    layers = triad(unit, space, 0.7 * radius, bit_scene.AXES, FRAMES) + triad(unit, centre, 1.1 * radius, bit_scene.AXES, FRAMES + 10)
    for k, cone in enumerate(bit.cones):
        s = spin_axes(cone)["s"]
        layers.append(bit_scene.arrows([cone_place(bit, k) - 1.42 * radius * s], [s], 0.8 * radius, bit_scene.cone_colour(k),
                                       0.03 * radius, FRAMES + 20 + k))
    bit_scene.show(place, render.picture(camera, render.joined(layers), [bit_scene.layer(bit)], opacity=0.42))
    label_triad(place, camera, unit, space, 0.7 * radius, bit_scene.AXES)
    label_triad(place, camera, unit, centre, 1.1 * radius, {n: bit_scene.AXES[n] for n in "xyz"})
    for k, cone in enumerate(bit.cones):
        label(place, camera, cone_place(bit, k) - 1.55 * radius * spin_axes(cone)["s"], f"s{k + 1}", bit_scene.cone_colour(k))
    ends = np.array([camera.place(space), camera.place(centre)])
    place.plot(*ends.T, color=style.BLACK, linewidth=1.1, linestyle="--")
    place.text(*(ends.mean(axis=0) + [0, -18]), "c", color=style.BLACK, fontsize=11, weight="bold", ha="center")
    place.text(*(camera.place(space) + [14, -14]), "W", color=style.BLACK, fontsize=11, weight="bold")
    place.text(*(camera.place(centre) + [14, -14]), "B", color=style.BLACK, fontsize=11, weight="bold")


def draw_cone(place, bit, dpi):
    """One cone: r from the bit's centre of mass to the cone's origin on the journal, and s, d, t there."""
    cone, radius = bit.cones[0], bit.analysis["gage_radius_m"]
    axes, middle = spin_axes(cone), cone_place(bit, 0)
    view = {"toward": tuple(0.35 * axes["d"] + 0.9 * axes["t"] - 0.2 * axes["s"]), "up": (0, 0, -1)}
    camera = bit_scene.camera(bit, view, INCHES, dpi, 1.3 * radius, middle)
    body = bit_scene.layer(bit, lambda p: p["cone"] == 0 and p["kind"] in ("cone", "tooth"))
    layers = triad(axes, middle, 0.95 * radius, SPIN, FRAMES)
    bit_scene.show(place, render.picture(camera, render.joined(layers), [body], opacity=0.5))
    label_triad(place, camera, axes, middle, 0.95 * radius, SPIN, "1")
    first, last = (camera.place(middle + along * radius * axes["s"]) for along in (-1.2, 1.2))
    place.plot(*np.array([first, last]).T, color=style.GREY, linewidth=1.0, linestyle="-.")
    place.text(*(first + [0, -20]), "journal", color=style.GREY, fontsize=9, ha="center")


def draw_bit(bit, dpi=style.DPI):
    figure, (whole, near) = bit_scene.canvas(2, INCHES)
    draw_whole(whole, bit, dpi)
    draw_cone(near, bit, dpi)
    return figure


def draw(inputs):
    return draw_bit(bit_data.read(inputs.only_folder()))
