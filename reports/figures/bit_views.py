"""Figures 3.2 to 3.5: a bit from below and in an isometric view."""

from figures import bit_data, bit_scene, render, style

INCHES = (3.6, 3.6)


def draw_bit(bit, dpi=style.DPI):
    figure, frames = bit_scene.canvas(2, INCHES)
    layer = bit_scene.layer(bit)
    for axes, view in zip(frames, (bit_scene.BELOW, bit_scene.ISOMETRIC)):
        bit_scene.show(axes, render.picture(bit_scene.camera(bit, view, INCHES, dpi), layer))
    return figure


def draw(inputs):
    return draw_bit(bit_data.read(inputs.only_folder()))
