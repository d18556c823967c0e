"""Figures 4.32, 4.34 and 4.38: the mesh of a drilled hole from the side, seen from the rock."""

from figures import render, results, rock_data, rock_scene, style

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


def draw(inputs):
    return draw_view(inputs.only_folder(), rock_scene.SIDE, SIDE_INCHES)
