"""Drilled holes (thesis 4.7 to 4.9, 4.26 to 4.39): from above, their mesh, the bit in its hole, and the mesh over many revolutions."""

import numpy as np
from matplotlib.colors import to_rgb

from figures import bit_scene, render, results, rock_data, rock_scene, style

INCHES_OF_HOLE_FROM_ABOVE = (6.0, 6.0)


def hole_from_above(inputs):
    """Figures 4.26, 4.28 and 4.37: the bottom of a hole from above."""
    folder = inputs.only_folder()
    mesh, run = rock_data.final(folder), results.summary(folder)
    norm = rock_scene.depth_norm(mesh)
    figure, axes = style.panels(1, 1, (7.6, 6.2))
    camera = rock_scene.camera(mesh.points, rock_scene.ABOVE, INCHES_OF_HOLE_FROM_ABOVE)
    rock_scene.show(axes, camera, render.picture(camera, rock_scene.layer(mesh, rock_scene.by_depth(mesh, norm))))
    axes.set_title(f"{run['title']}, {run['revolutions']:.3g} revolutions, {len(mesh.triangles)} triangles")
    rock_scene.depth_bar(figure, axes, norm)
    return figure


SIDE_INCHES, BELOW_INCHES = (6.2, 4.2), (6.2, 6.2)


def draw_view(folder, view, inches):
    mesh, run = rock_data.final(folder), results.summary(folder)
    figure, axes = style.panels(1, 1, (inches[0] + 1.2, inches[1] + 0.3))
    camera = rock_scene.camera(mesh.points, view, inches, dpi=style.DPI)
    layer = rock_scene.layer_from_rock(mesh, rock_scene.by_quality(mesh), view)
    rock_scene.show(axes, camera, render.picture(camera, layer))
    quality = mesh.cell_values["quality"]
    axes.set_title(f"{run['title']}, {run['revolutions']:.3g} revolutions: {len(quality)} triangles, worst quality "
                   f"{quality.min():.2f}, {100 * (quality > 0.5).mean():.2f} % above 0.5")
    rock_scene.quality_bar(figure, axes)
    return figure


def hole_mesh(inputs):
    """Figures 4.32, 4.34 and 4.38: the mesh of a drilled hole from the side, seen from the rock."""
    return draw_view(inputs.only_folder(), rock_scene.SIDE, SIDE_INCHES)


def hole_mesh_below(inputs):
    """Figures 4.33, 4.35 and 4.39: the mesh of a drilled hole from below."""
    return draw_view(inputs.only_folder(), rock_scene.BELOW, BELOW_INCHES)


INCHES_OF_BIT_IN_HOLE = (4.6, 4.6)
ROCK = "#c9b79c"
BODY = to_rgb(bit_scene.KINDS["bit-body"])


def bit_layer(mesh):
    """Cutters grey, their faces dark; of a roller cone bit the teeth of each cone in its colour."""
    kinds = ("face", "chamfer", "cse", "cutter-body", "gage-pad", "bit-body", "cone", "tooth")
    kind = mesh.cell_values["kind"].astype(int)
    cone = mesh.cell_values.get("cone", np.full(len(kind), -1.0)).astype(int)
    table = np.array([to_rgb(bit_scene.KINDS[k]) for k in kinds])
    colours = table[kind]
    for k in np.unique(cone[cone >= 0]):
        own = np.array(to_rgb(bit_scene.cone_colour(k)))
        colours[(cone == k) & (kind == kinds.index("tooth"))] = own
        colours[(cone == k) & (kind == kinds.index("cone"))] = 0.25 * own + 0.75 * np.array(to_rgb(bit_scene.KINDS["cone"]))
    return render.Layer(mesh.corners, colours, 1 + mesh.cell_values["part"].astype(int))


def picture(folder, inches):
    """Rock in one colour, the bit in its own, its body seen through."""
    rock, bit = rock_data.final(folder), bit_layer(rock_data.final(folder, "bit"))
    camera = rock_scene.camera(np.concatenate([rock.points, bit.corners.reshape(-1, 3)]), rock_scene.INTO_HOLE,
                               inches, dpi=0.75 * style.DPI)
    colours = np.broadcast_to(to_rgb(ROCK), (len(rock.triangles), 3))
    body = (bit.colours == BODY).all(axis=1)
    solid = render.joined([rock_scene.layer(rock, colours), part_of(bit, ~body)])
    return render.picture(camera, solid, ghosts=[part_of(bit, body)], opacity=0.3)


def part_of(layer, take):
    return render.Layer(layer.corners[take], layer.colours[take], layer.owners[take])


def words(run):
    return f"{run['title']}, {'at the start' if run['steps'] == 1 else format(run['revolutions'], '.3g') + ' revolutions'}"


def bit_in_hole(inputs):
    """Figures 4.29 to 4.31: bits in their holes, seen through the nearer wall."""
    folders = inputs.folders()
    figure, frames = bit_scene.canvas(len(folders), INCHES_OF_BIT_IN_HOLE)
    for axes, folder in zip(frames, folders):
        rock_scene.show_free(axes, picture(folder, INCHES_OF_BIT_IN_HOLE))
        axes.text(0.02, 0.98, words(results.summary(folder)), transform=axes.transAxes, va="top")
    return figure


MM = 1e3
MAGENTA = "#d6139a"


def slice_of(mesh, edge):
    """Indices of the vertices nearest to the half-plane y = 0, x > 0, one of each ring of the start, from the axis
    up the wall."""
    x, y, z = mesh.points.T
    beside = np.flatnonzero((np.abs(y) < 0.7 * edge) & (x > -0.25 * edge))
    rings = np.round(np.stack([np.hypot(x, y), -z], axis=1)[beside] / (0.05 * edge))  # all of a ring in one place
    order = np.argsort(np.abs(y[beside]), kind="stable")
    _, first = np.unique(rings[order], axis=0, return_index=True)  # by radius, on the wall upwards
    return beside[order][first]


def rz(mesh, numbers):
    return np.hypot(*mesh.points[numbers, :2].T) * MM, mesh.points[numbers, 2] * MM


def spacing(r, z):
    return np.hypot(np.diff(r), np.diff(z))


def draw_slice(axes, r, z, words):
    axes.plot(r, z, "o-", color=style.BLACK, markersize=2.2, linewidth=0.7)
    axes.set(xlabel="radius (mm)", aspect="equal")
    axes.set_title(words, loc="left")


def vertex_divergence(inputs):
    """Figures 4.7 to 4.9: a vertical slice of the mesh before and after drilling, for one rule of update directions."""
    start, end = inputs.folders()
    before, after = rock_data.final(start), rock_data.final(end)
    if len(before.points) != len(after.points):
        raise ValueError(f"{end}: the mesh was maintained, its vertices cannot be followed")
    edge = np.median(np.linalg.norm(np.diff(before.corners[:, :2], axis=1), axis=2))
    numbers = slice_of(before, edge)
    (r0, z0), (r1, z1) = rz(before, numbers), rz(after, numbers)
    figure, (left, right) = style.panels(1, 2, (9.6, 4.9), sharex=True, sharey=True)
    moved = np.hypot(r1 - r0, z1 - z0) > 0.05 * MM * edge
    way = np.stack([r1 - r0, z1 - z0])[:, moved] / np.hypot(r1 - r0, z1 - z0)[moved]
    draw_slice(left, r0, z0, "before, with the way that each vertex went")
    left.quiver(r0[moved], z0[moved], *(2.2 * MM * edge * way), color=MAGENTA, angles="xy", scale_units="xy", scale=1.0, width=0.003)
    run, ratio = results.summary(end), spacing(r1, z1) / (MM * edge)
    draw_slice(right, r1, z1, f"after {run['revolutions']:.3g} revolutions without maintenance:\nneighbours "
               f"{ratio.min():.2f} to {ratio.max():.1f} edge lengths apart")
    left.set_ylim(z1.max() + 4, -70)
    left.set_xlim(-4, 122)
    left.set_ylabel("z (mm, down)")
    return figure


BINS = np.linspace(0, 1, 51)


def quality_histogram(inputs):
    """Addition of TDBD to 4.2.4.4: the shape quality of the rock's triangles at the beginning, in the middle and at the end of runs."""
    folders = inputs.folders()
    figure, frames = style.panels(1, len(folders), (4.8 * len(folders), 3.4), sharey=True, squeeze=False)
    for axes, folder in zip(frames[0], folders):
        run, made = results.summary(folder), rock_data.frames(folder)
        for (time, path), colour in zip((made[0], made[len(made) // 2], made[-1]), (style.GREY, style.SKY, style.RED)):
            quality = rock_data.read(path).cell_values["quality"]
            turns = run["revolutions"] * time / run["duration_s"]
            axes.hist(quality, BINS, weights=np.full(len(quality), 100 / len(quality)), histtype="step", linewidth=1.4,
                      color=colour, label=f"{turns:.0f} revolutions, {len(quality)} triangles")
        axes.set(yscale="log", xlim=(0, 1), xlabel="shape quality, 1: equilateral", title=run["title"])
        axes.legend(loc="upper left")
    frames[0][0].set_ylabel("share of triangles (%), bins of 0.02")
    return figure


COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE)


def over_frames(folder):
    """(revolutions, worst quality, quality that 99 % exceed, share above 0.5) of every frame."""
    run = results.summary(folder)
    turns = run["revolutions"] / run["duration_s"]
    rows = []
    for time, path in rock_data.frames(folder):
        quality = rock_data.read(path).cell_values["quality"]
        rows.append((turns * time, quality.min(), np.quantile(quality, 0.01), (quality > 0.5).mean()))
    return np.array(rows).T


def draw_run(frames, folder, colour):
    run = results.summary(folder)
    turns, worst, low, _ = over_frames(folder)
    frames[0].plot(turns, worst, "o-", color=colour, label=f"{run['title']}: worst")
    frames[0].plot(turns, low, "--", color=colour, label=f"{run['title']}: 1 % quantile")
    angle, triangles = results.history(folder, "rotation_angle", "rock_triangles")
    frames[1].plot(np.abs(angle) / (2 * np.pi), triangles / run["rock_triangles_start"], color=colour, label=run["title"])
    volumes = np.array(run["removed_volume_by_revolution_m3"])[:int(run["revolutions"] + 1e-9)]
    depth, = results.history(folder, "position_z")
    whole = np.pi * run["gage_radius_m"]**2 * depth[-1] / run["revolutions"]
    frames[2].plot(1 + np.arange(len(volumes)), volumes / whole, color=colour, label=run["title"])


def long_term(inputs):
    """Addition of TDBD to section 4.4.2: mesh and hole over many revolutions."""
    figure, frames = style.panels(1, 3, (11.0, 3.6))
    for folder, colour in zip(inputs.folders(), COLOURS):
        draw_run(frames, folder, colour)
    frames[0].set(xlabel="revolutions", ylabel="quality of triangles", ylim=(0, 1))
    frames[1].set(xlabel="revolutions", ylabel="triangles over those at the start")
    frames[2].set(xlabel="revolution", ylabel="volume removed over pi R$^2$ d")
    for axes in frames:
        axes.legend()
    return figure
