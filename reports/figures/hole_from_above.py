"""Figures 4.26, 4.28 and 4.37: the bottom of a hole from above."""

from figures import render, results, rock_data, rock_scene, style

INCHES = (6.0, 6.0)


def draw(inputs):
    folder = inputs.only_folder()
    mesh, run = rock_data.final(folder), results.summary(folder)
    norm = rock_scene.depth_norm(mesh)
    figure, axes = style.panels(1, 1, (7.6, 6.2))
    camera = rock_scene.camera(mesh.points, rock_scene.ABOVE, INCHES)
    rock_scene.show(axes, camera, render.picture(camera, rock_scene.layer(mesh, rock_scene.by_depth(mesh, norm))))
    axes.set_title(f"{run['title']}, {run['revolutions']:.3g} revolutions, {len(mesh.triangles)} triangles")
    rock_scene.depth_bar(figure, axes, norm)
    return figure
