"""Figures 4.29 to 4.31: bits in their holes, seen through the nearer wall."""

import numpy as np
from matplotlib.colors import to_rgb

from figures import bit_scene, render, results, rock_data, rock_scene, style

INCHES = (4.6, 4.6)
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


def draw(inputs):
    folders = inputs.folders()
    figure, frames = bit_scene.canvas(len(folders), INCHES)
    for axes, folder in zip(frames, folders):
        rock_scene.show_free(axes, picture(folder, INCHES))
        axes.text(0.02, 0.98, words(results.summary(folder)), transform=axes.transAxes, va="top")
    return figure
