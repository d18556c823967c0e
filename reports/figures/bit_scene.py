"""A bit as a scene: colours by kind, blade and cone; arrows; views."""

import numpy as np
from matplotlib.colors import to_rgb

from figures import render, style

# Parts that are not cutters, and cutters of a bit without blades.
KINDS = {"face": "#2b2f36", "chamfer": "#7d8794", "land": "#7d8794", "cse": "#59636f", "cutter-body": "#b9bec4",
         "gage-pad": "#c9a45c", "bit-body": "#aebac6", "cone": "#b4bbc3", "tooth": "#3d4653"}
OTHER = "#9aa7b5"
BLADES = ("#0072B2", "#D55E00", "#009E73", "#B3569B", "#E69F00", "#56B4E9", "#7a5b3a", "#4d4d9f", "#8fae2c", "#c23b5a")
# Fig. 3.5 of the thesis: the teeth of cone one are red, of two green, of three blue.
CONES = ("#c8322b", "#2f9e44", "#2462c2", "#E69F00", "#B3569B", "#56B4E9")
AXES = {"x": "#2462c2", "y": "#2f9e44", "z": "#c8322b"}  # figs. 3.6 and 3.7: blue, green, red
MAGENTA = "#d6139a"  # update directions in figs. 4.4 and 4.5
BELOW = {"toward": (0, 0, 1), "up": (0, 1, 0)}
ISOMETRIC = {"toward": (0.62, -0.62, 0.66), "up": (0, 0, -1)}
SIDES = 20  # of an arrow
FACE_LIFT = 2e-5  # m: a chamfer encloses its face, so that both have the face's front


def blade_colour(blade):
    return BLADES[(int(blade) - 1) % len(BLADES)]


def cone_colour(cone):
    return CONES[int(cone) % len(CONES)]


def colour_of(bit, part):
    """By kind; cutters by blade, paler behind the face; teeth by cone, a cone as a paler tooth."""
    if part["cone"] >= 0 and part["kind"] in ("tooth", "cone"):
        tooth = np.array(to_rgb(cone_colour(part["cone"])))
        return tooth if part["kind"] == "tooth" else 0.25 * tooth + 0.75 * np.array(to_rgb(KINDS["cone"]))
    own = np.array(to_rgb(KINDS.get(part["kind"], OTHER)))
    if not 0 <= part["cutter"] < len(bit.cutters):
        return own
    blade = np.array(to_rgb(blade_colour(bit.cutters[part["cutter"]]["blade"])))
    return {"face": blade, "cutter-body": 0.45 * blade + 0.55 * own}.get(part["kind"], own)


def layer(bit, wanted=lambda part: True, colour=None, wires=False):
    """The parts that are wanted, with their colours or all in one."""
    corners, normals, owner = bit.corners(wanted)
    table = np.array([to_rgb(colour) if colour else colour_of(bit, p) for p in bit.parts])
    lift = np.array([FACE_LIFT if p["kind"] == "face" else 0.0 for p in bit.parts])
    return render.Layer(corners, table[owner], owner, wires, lift[owner], normals)


def across(direction):
    """Two unit vectors normal to a unit one."""
    helper = np.eye(3)[np.argmin(np.abs(direction))]
    first = render.unit(np.cross(direction, helper))
    return first, np.cross(direction, first)


def cone_between(start, end, radii):
    """Triangles of a closed frustum, outward."""
    first, second = across(render.unit(end - start))
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    ring = np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second
    a, b = start + radii[0] * ring, end + radii[1] * ring
    c, d = np.roll(a, -1, axis=0), np.roll(b, -1, axis=0)
    foot, tip = np.broadcast_to(start, a.shape), np.broadcast_to(end, a.shape)
    return np.concatenate([np.stack(t, axis=1) for t in ((a, c, d), (a, d, b), (foot, c, a), (tip, b, d))])


def arrows(starts, directions, length, colour, width=None, owner=10**6):
    """Solid arrows of one length, each with its head."""
    width = width or 0.045 * length
    triangles, owners = [], []
    for k, (start, direction) in enumerate(zip(np.asarray(starts, float), render.unit(directions))):
        neck, end = start + (length - 5.5 * width) * direction, start + length * direction
        both = np.concatenate([cone_between(start, neck, (width, width)),
                               cone_between(neck, end, (2.4 * width, 1e-3 * width))])
        triangles.append(both)
        owners.append(np.full(len(both), owner + k))
    corners = np.concatenate(triangles)
    return render.Layer(corners, np.broadcast_to(to_rgb(colour), (len(corners), 3)), np.concatenate(owners))


def camera(bit, view, inches, dpi, reach=None, centre=None):
    """Looks at the whole bit, or at a part of it within `reach` (m) of a centre."""
    points = bit.points if centre is None else np.asarray(centre) + reach * np.array([[-1, -1, -1], [1, 1, 1]])
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0)) if centre is None else np.asarray(centre)
    pixels = tuple(int(round(dpi * x)) for x in inches)
    one = render.Camera(centre=tuple(middle), width=1.0, pixels=pixels, **view)
    if centre is not None:
        return render.Camera(centre=tuple(middle), width=2 * reach, pixels=pixels, **view)
    seen = (points - middle) @ one.axes()[:2].T
    low, high = seen.min(axis=0), seen.max(axis=0)
    shift = 0.5 * (low + high) @ one.axes()[:2]
    width = 1.06 * max(high[0] - low[0], (high[1] - low[1]) * pixels[0] / pixels[1])
    return render.Camera(centre=tuple(middle + shift), width=width, pixels=pixels, **view)


def show(axes, image):
    """A picture that fills its axes."""
    axes.imshow(image, interpolation="antialiased", aspect="equal")
    axes.set_axis_off()


def canvas(columns, inches):
    """A figure of pictures side by side, each of these inches."""
    figure = style.Figure(figsize=(columns * inches[0], inches[1]))
    frames = [figure.add_axes([k / columns, 0, 1 / columns, 1]) for k in range(columns)]
    return figure, frames
