"""Figures 4.4 and 4.5: the directions in which the parts of a bit move rock."""

import numpy as np

from figures import bit_data, bit_scene, render, style

INCHES = (3.6, 3.6)


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


def draw_bit(bit, dpi=style.DPI):
    figure, frames = bit_scene.canvas(2, INCHES)
    length = 0.2 * bit.analysis["gage_radius_m"]
    places, vectors = zip(*starts(bit))
    scene = render.joined([bit_scene.layer(bit),
                           bit_scene.arrows(places, vectors, length, bit_scene.MAGENTA, 0.045 * length)])
    for axes, view in zip(frames, (bit_scene.BELOW, bit_scene.ISOMETRIC)):
        camera = bit_scene.camera(bit, view, INCHES, dpi)
        camera = render.Camera(camera.toward, camera.up, camera.centre, 1.12 * camera.width, camera.pixels)
        bit_scene.show(axes, render.picture(camera, scene))
    return figure


def draw(inputs):
    return draw_bit(bit_data.read(inputs.only_folder()))
