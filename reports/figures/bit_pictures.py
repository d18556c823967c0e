"""Pictures of bits (thesis 3.2 to 3.10, 4.4 to 4.6, 5.1, A.1) and tables A.1 to A.3: views, frames, meshes, update directions."""

import numpy as np

from figures import bit_charts, bit_data, bit_scene, render, results, style

INCHES_OF_BIT_VIEWS = (3.6, 3.6)


def draw_views(bit, dpi=style.DPI):
    figure, frames = bit_scene.canvas(2, INCHES_OF_BIT_VIEWS)
    layer = bit_scene.layer(bit)
    for axes, view in zip(frames, (bit_scene.BELOW, bit_scene.ISOMETRIC)):
        bit_scene.show(axes, render.picture(bit_scene.camera(bit, view, INCHES_OF_BIT_VIEWS, dpi), layer))
    return figure


def bit_views(inputs):
    """Figures 3.2 to 3.5: a bit from below and in an isometric view."""
    return draw_views(bit_data.read(inputs.only_folder()))


INCHES_OF_BIT_FRAME = (4.6, 4.6)


def draw_frame(bit, dpi=style.DPI):
    figure, [axes] = bit_scene.canvas(1, INCHES_OF_BIT_FRAME)
    centre, length = np.array(bit.analysis["centre_m"]), 1.5 * bit.analysis["gage_radius_m"]
    camera = bit_scene.camera(bit, bit_scene.ISOMETRIC, INCHES_OF_BIT_FRAME, dpi)
    camera = render.Camera(camera.toward, camera.up, camera.centre, 1.15 * camera.width, camera.pixels)
    solid = render.joined([bit_scene.arrows([centre], [direction], length, bit_scene.AXES[name], 0.022 * length, -2 - k)
                           for k, (name, direction) in enumerate(zip("xyz", np.eye(3)))])
    bit_scene.show(axes, render.picture(camera, solid, [bit_scene.layer(bit)], opacity=0.42))
    for name, direction in zip("xyz", np.eye(3)):
        x, y = camera.place(centre + 1.1 * length * direction)
        axes.text(x, y, name, color=bit_scene.AXES[name], fontsize=13, weight="bold", ha="center", va="center")
    return figure


def bit_frame(inputs):
    """Figure 3.6: the bit's coordinate system, through a partly transparent bit."""
    return draw_frame(bit_data.read(inputs.only_folder()))


INCHES_OF_CUTTER_FRAMES = (3.6, 3.6)


def frames(cutters, length):
    """Arrows x, y, z of the cutters' frames, in the colours of the thesis's figure."""
    starts = np.array([c["face_centre_m"] for c in cutters])
    return [bit_scene.arrows(starts, [c[f"{name}_axis"] for c in cutters], length, bit_scene.AXES[name],
                             0.05 * length, (k + 2) * 10**6) for k, name in enumerate("xyz")]


def near_view(cutter):
    """From ahead of the cutter, beside it, and below."""
    x, y, z = (np.array(cutter[f"{name}_axis"]) for name in "xyz")
    return {"toward": tuple(0.75 * x - 0.55 * y - 0.35 * z), "up": tuple(z)}


def draw_cutter_frames(bit, dpi=style.DPI):
    figure, (whole, near) = bit_scene.canvas(2, INCHES_OF_CUTTER_FRAMES)
    length = float(np.mean(bit.column("diameter_m")))
    scene = render.joined([bit_scene.layer(bit, lambda p: p["kind"] != "bit-body"), *frames(bit.cutters, length)])
    body = bit_scene.layer(bit, lambda p: p["kind"] == "bit-body")
    camera = bit_scene.camera(bit, bit_scene.BELOW, INCHES_OF_CUTTER_FRAMES, dpi)
    camera = render.Camera(camera.toward, camera.up, camera.centre, 1.08 * camera.width, camera.pixels)
    bit_scene.show(whole, render.picture(camera, render.joined([body, scene])))
    one = bit.cutters[len(bit.cutters) // 2]
    camera = bit_scene.camera(bit, near_view(one), INCHES_OF_CUTTER_FRAMES, dpi, 1.25 * length,
                              np.array(one["face_centre_m"]) + 0.15 * length * np.array(one["x_axis"]))
    alone = render.joined([bit_scene.layer(bit, lambda p: p["cutter"] == bit.cutters.index(one)), *frames([one], length)])
    bit_scene.show(near, render.picture(camera, alone))
    for name in "xyz":
        x, y = camera.place(np.array(one["face_centre_m"]) + 1.12 * length * np.array(one[f"{name}_axis"]))
        near.text(x, y, name, color=bit_scene.AXES[name], fontsize=12, weight="bold", ha="center", va="center")
    return figure


def cutter_frames(inputs):
    """Figure 3.7: the frame of every cutter, and one of them close up."""
    return draw_cutter_frames(bit_data.read(inputs.only_folder()))


INCHES_OF_BIT_MESHES = (3.6, 3.6)


def cutter_mesh(axes, bit, dpi):
    """Face and chamfer of the cutter in the middle of the table, seen along its axis."""
    k = len(bit.cutters) // 2
    one = bit.cutters[k]
    layer = render.joined([bit_scene.layer(bit, lambda p: p["cutter"] == k and p["kind"] == kind, colour, True)
                           for kind, colour in (("face", "#a9c6e3"), ("chamfer", "#e3c9a0"))])
    view = {"toward": tuple(one["x_axis"]), "up": tuple(-np.array(one["z_axis"]))}
    camera = bit_scene.camera(bit, view, INCHES_OF_BIT_MESHES, dpi, 0.54 * one["diameter_m"], one["face_centre_m"])
    bit_scene.show(axes, render.picture(camera, layer))


def draw_cutters(bits, dpi=style.DPI):
    figure, frames = bit_scene.canvas(len(bits), INCHES_OF_BIT_MESHES)
    for axes, bit in zip(frames, bits):
        cutter_mesh(axes, bit, dpi)
        axes.text(0.02, 0.98, f"{bit.name}", transform=axes.transAxes, va="top", fontsize=10, weight="bold")
    return figure


def draw_teeth(bit, dpi=style.DPI):
    """The first cone from its side, and the meshes of its visible teeth."""
    figure, frames = bit_scene.canvas(2, INCHES_OF_BIT_MESHES)
    cone = bit.cones[0]
    axis, origin = np.array(cone["axis"]), np.array(cone["origin_m"])
    toward = render.unit(np.cross(axis, [0.0, 0.0, 1.0])) - 0.35 * axis
    teeth = [p for p in bit.parts if p["cone"] == 0 and p["kind"] == "tooth"]
    places = np.array([p["origin_m"] for p in teeth])
    out = places - origin - np.outer((places - origin) @ axis, axis)
    seen = {p["name"] for p, o in zip(teeth, out) if o @ toward > -0.1 * np.linalg.norm(o)}
    view = {"toward": tuple(toward), "up": tuple(np.cross(axis, toward))}
    camera = bit_scene.camera(bit, view, INCHES_OF_BIT_MESHES, dpi, 0.62 * np.ptp(places, axis=0).max(), places.mean(axis=0))
    bit_scene.show(frames[0], render.picture(camera, bit_scene.layer(bit, lambda p: p["cone"] == 0)))
    meshes = bit_scene.layer(bit, lambda p: p["name"] in seen, "#d9a3a0", True)
    bit_scene.show(frames[1], render.picture(camera, meshes))
    return figure


def bit_meshes(inputs):
    """Figures 3.9 and 3.10: meshes of a cutter's face and chamfer, and of a row of teeth."""
    bits = [bit_data.read(folder) for folder in inputs.folders()]
    return draw_teeth(bits[0]) if bits[0].cones else draw_cutters(bits)


INCHES_OF_UPDATE_DIRECTIONS = (3.6, 3.6)


def turned(direction, place):
    """A direction at azimuth 0, turned about the bit's axis to the azimuth of a place (4.1.3.2)."""
    angle = np.arctan2(place[1], place[0])
    x, y, z = direction
    return [x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle), z]


def starts(bit):
    """(place, update direction there) for every cutter, or every part that cuts."""
    own = {p["cutter"]: p for p in bit.parts if p["cutter"] >= 0}
    if bit.cutters and own:
        return [(c["tip_m"], turned(own[k]["update_direction"], c["tip_m"])) for k, c in enumerate(bit.cutters)]
    return [(centre, turned(p["update_direction"], centre)) for p, centre in zip(bit.parts, bit.centres)
            if p["cuts"] and p["kind"] not in ("chamfer", "cutter-body", "cone")]


def draw_update_directions(bit, dpi=style.DPI):
    figure, frames = bit_scene.canvas(2, INCHES_OF_UPDATE_DIRECTIONS)
    length = 0.2 * bit.analysis["gage_radius_m"]
    places, vectors = zip(*starts(bit))
    scene = render.joined([bit_scene.layer(bit),
                           bit_scene.arrows(places, vectors, length, bit_scene.MAGENTA, 0.045 * length)])
    for axes, view in zip(frames, (bit_scene.BELOW, bit_scene.ISOMETRIC)):
        camera = bit_scene.camera(bit, view, INCHES_OF_UPDATE_DIRECTIONS, dpi)
        camera = render.Camera(camera.toward, camera.up, camera.centre, 1.12 * camera.width, camera.pixels)
        bit_scene.show(axes, render.picture(camera, scene))
    return figure


def update_directions(inputs):
    """Figures 4.4 and 4.5: the directions in which the parts of a bit move rock."""
    return draw_update_directions(bit_data.read(inputs.only_folder()))


LENGTH = 9.0  # mm, of an arrow


def in_half_plane(vector, place):
    """(r, z) of a vector at the azimuth of a place."""
    outward = np.array([*place[:2], 0.0]) / np.hypot(*place[:2])
    return np.dot(vector, outward), vector[2]


def arrow(axes, start, direction, colour, width=0.0035):
    axes.quiver(*start, *(LENGTH * np.array(direction) / np.hypot(*direction)), color=colour, angles="xy",
                scale_units="xy", scale=1.0, width=width, zorder=3)


def inside_outside(inputs):
    """Figure 4.6: which cutters are inside and which outside, and where each moves rock."""
    bit = bit_data.read(inputs.only_folder())
    own = {p["cutter"]: p["update_direction"] for p in bit.parts if p["cutter"] >= 0}
    figure, axes = style.panels(1, 1, (7.6, 4.6))
    for k, cutter in enumerate(bit.cutters):
        r, z = bit_charts.rz(cutter["outline_rz_m"])
        exposure = in_half_plane(-np.array(cutter["z_axis"]), cutter["face_centre_m"])
        colour = style.BLUE if exposure[0] > 0 else style.GREEN
        axes.fill(r, z, facecolor=colour, edgecolor=colour, alpha=0.15)
        arrow(axes, bit_charts.rz([(np.hypot(*cutter["face_centre_m"][:2]), cutter["face_centre_m"][2])]), exposure, style.GREY)
        arrow(axes, bit_charts.rz([(cutter["tip_radius_m"], cutter["tip_m"][2])]), own[k][::2], "#d6139a", 0.005)
    for colour, words in ((style.GREEN, "inside cutters"), (style.BLUE, "outside cutters"),
                          (style.GREY, "-Z of the cutter's frame"), ("#d6139a", "update direction")):
        axes.plot([], [], "s", color=colour, label=words)
    bit_charts.half_plane(axes)
    bit_charts.show_cutters(axes, bit)
    axes.set_ylim(axes.get_ylim()[0] + LENGTH, axes.get_ylim()[1])
    axes.set_xlim(axes.get_xlim()[0], axes.get_xlim()[1] + LENGTH)
    axes.legend(loc="upper left")
    return figure


def draw_bits(bits):
    figure, panels = style.panels(len(bits), 1, (7.4, 4.4 * len(bits)), sharex=True, squeeze=False)
    for axes, bit in zip(panels[:, 0], bits):
        bit_charts.draw_outlines(axes, bit)
        bit_charts.half_plane(axes)
        bit_charts.show_cutters(axes, bit)
        bit_charts.blade_legend(axes, bit)
        axes.set_title(bit.name, loc="left", weight="bold")
    return figure


def exposure_profiles(inputs):
    """Figure 3.8: exposure profiles, every cutter turned into one half-plane."""
    return draw_bits([bit_data.read(folder) for folder in inputs.folders()])


INCHES_OF_FOUR_BITS = (2.4, 3.0)
SIDE = {"toward": (0.80, -0.60, 0.30), "up": (0, 0, -1)}


def four_bits(inputs):
    """Figure A.1: the bits together, each from the side and from below, to one scale."""
    bits = [bit_data.read(folder) for folder in inputs.folders()]
    figure = style.Figure(figsize=(len(bits) * INCHES_OF_FOUR_BITS[0], 2 * INCHES_OF_FOUR_BITS[1]))
    for row, view in enumerate((SIDE, bit_scene.BELOW)):
        cameras = [bit_scene.camera(bit, view, INCHES_OF_FOUR_BITS, style.DPI) for bit in bits]
        width = max(c.width for c in cameras)
        for k, (bit, camera) in enumerate(zip(bits, cameras)):
            axes = figure.add_axes([k / len(bits), 0.48 * (1 - row), 1 / len(bits), 0.48])
            camera = render.Camera(camera.toward, camera.up, camera.centre, width, (camera.pixels[0], int(0.96 * camera.pixels[1])))
            bit_scene.show(axes, render.picture(camera, bit_scene.layer(bit)))
            if row == 0:
                figure.text((k + 0.5) / len(bits), 0.97, f"Bit {bit.name[-1].upper()}", weight="bold", fontsize=11, ha="center")
    return figure


INCHES_OF_CONE_FRAMES = (4.9, 4.0)
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
    camera = widened(bit_scene.camera(bit, VIEW, INCHES_OF_CONE_FRAMES, dpi), 1.32, (0.0, 0.42 * radius, 0.0))
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
    camera = bit_scene.camera(bit, view, INCHES_OF_CONE_FRAMES, dpi, 1.3 * radius, middle)
    body = bit_scene.layer(bit, lambda p: p["cone"] == 0 and p["kind"] in ("cone", "tooth"))
    layers = triad(axes, middle, 0.95 * radius, SPIN, FRAMES)
    bit_scene.show(place, render.picture(camera, render.joined(layers), [body], opacity=0.5))
    label_triad(place, camera, axes, middle, 0.95 * radius, SPIN, "1")
    first, last = (camera.place(middle + along * radius * axes["s"]) for along in (-1.2, 1.2))
    place.plot(*np.array([first, last]).T, color=style.GREY, linewidth=1.0, linestyle="-.")
    place.text(*(first + [0, -20]), "journal", color=style.GREY, fontsize=9, ha="center")


def draw_cone_frames(bit, dpi=style.DPI):
    figure, (whole, near) = bit_scene.canvas(2, INCHES_OF_CONE_FRAMES)
    draw_whole(whole, bit, dpi)
    draw_cone(near, bit, dpi)
    return figure


def cone_frames(inputs):
    """Figure 5.1: the coordinate systems of a roller cone bit: space, bit, and a cone with its axis."""
    return draw_cone_frames(bit_data.read(inputs.only_folder()))


HEADS = ("region", "cutters", "numbers", "diameter mm", "chamfer mm", "from the axis mm")


def ranges(numbers):
    """"1 to 4, 7" of 1, 2, 3, 4, 7."""
    found = []
    for n in sorted(numbers):
        if found and found[-1][1] == n - 1:
            found[-1][1] = n
        else:
            found.append([n, n])
    return ", ".join(str(a) if a == b else f"{a} to {b}" for a, b in found)


def row(zone, cutters):
    """Cutters of one size."""
    radii = [1e3 * c["tip_radius_m"] for c in cutters]
    return [zone, len(cutters), ranges(int(c["name"].rsplit("-", 1)[1]) for c in cutters), f"{1e3 * cutters[0]['diameter_m']:.2f}",
            f"{1e3 * cutters[0]['chamfer_m']:.2f}", f"{min(radii):.1f} to {max(radii):.1f}"]


def cutter_sizes(inputs):
    """Tables A.1 to A.3: cutters and their chamfers, by region of the bit."""
    sizes = {}
    for c in results.read_json(inputs.only_folder(), "bit.json")["cutters"]:
        sizes.setdefault((c["zone"], c["diameter_m"], c["chamfer_m"]), []).append(c)
    rows = [row(zone, cutters) for (zone, _, _), cutters in sizes.items()]
    return {"heads": HEADS, "rows": rows}
