"""Figure 3.6: the bit's coordinate system, through a partly transparent bit."""

import numpy as np

from figures import bit_data, bit_scene, render, style

INCHES = (4.6, 4.6)


def draw_bit(bit, dpi=style.DPI):
    figure, [axes] = bit_scene.canvas(1, INCHES)
    centre, length = np.array(bit.analysis["centre_m"]), 1.5 * bit.analysis["gage_radius_m"]
    camera = bit_scene.camera(bit, bit_scene.ISOMETRIC, INCHES, dpi)
    camera = render.Camera(camera.toward, camera.up, camera.centre, 1.15 * camera.width, camera.pixels)
    solid = render.joined([bit_scene.arrows([centre], [direction], length, bit_scene.AXES[name], 0.022 * length, -2 - k)
                           for k, (name, direction) in enumerate(zip("xyz", np.eye(3)))])
    bit_scene.show(axes, render.picture(camera, solid, [bit_scene.layer(bit)], opacity=0.42))
    for name, direction in zip("xyz", np.eye(3)):
        x, y = camera.place(centre + 1.1 * length * direction)
        axes.text(x, y, name, color=bit_scene.AXES[name], fontsize=13, weight="bold", ha="center", va="center")
    return figure


def draw(inputs):
    return draw_bit(bit_data.read(inputs.only_folder()))
