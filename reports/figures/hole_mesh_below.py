"""Figures 4.33, 4.35 and 4.39: the mesh of a drilled hole from below."""

from figures import hole_mesh, rock_scene


def draw(inputs):
    return hole_mesh.draw_view(inputs.only_folder(), rock_scene.BELOW, hole_mesh.BELOW_INCHES)
