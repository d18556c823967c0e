"""Figure 3.7: the frame of every cutter, and one of them close up."""

import numpy as np

from figures import bit_data, bit_scene, render, style

INCHES = (3.6, 3.6)


def frames(cutters, length):
    """Arrows x, y, z of the cutters' frames, in the colours of the thesis's figure."""
    starts = np.array([c["face_centre_m"] for c in cutters])
    return [bit_scene.arrows(starts, [c[f"{name}_axis"] for c in cutters], length, bit_scene.AXES[name],
                             0.05 * length, (k + 2) * 10**6) for k, name in enumerate("xyz")]


def near_view(cutter):
    """From ahead of the cutter, beside it, and below."""
    x, y, z = (np.array(cutter[f"{name}_axis"]) for name in "xyz")
    return {"toward": tuple(0.75 * x - 0.55 * y - 0.35 * z), "up": tuple(z)}


def draw_bit(bit, dpi=style.DPI):
    figure, (whole, near) = bit_scene.canvas(2, INCHES)
    length = float(np.mean(bit.column("diameter_m")))
    scene = render.joined([bit_scene.layer(bit, lambda p: p["kind"] != "bit-body"), *frames(bit.cutters, length)])
    body = bit_scene.layer(bit, lambda p: p["kind"] == "bit-body")
    camera = bit_scene.camera(bit, bit_scene.BELOW, INCHES, dpi)
    camera = render.Camera(camera.toward, camera.up, camera.centre, 1.08 * camera.width, camera.pixels)
    bit_scene.show(whole, render.picture(camera, render.joined([body, scene])))
    one = bit.cutters[len(bit.cutters) // 2]
    camera = bit_scene.camera(bit, near_view(one), INCHES, dpi, 1.25 * length,
                              np.array(one["face_centre_m"]) + 0.15 * length * np.array(one["x_axis"]))
    alone = render.joined([bit_scene.layer(bit, lambda p: p["cutter"] == bit.cutters.index(one)), *frames([one], length)])
    bit_scene.show(near, render.picture(camera, alone))
    for name in "xyz":
        x, y = camera.place(np.array(one["face_centre_m"]) + 1.12 * length * np.array(one[f"{name}_axis"]))
        near.text(x, y, name, color=bit_scene.AXES[name], fontsize=12, weight="bold", ha="center", va="center")
    return figure


def draw(inputs):
    return draw_bit(bit_data.read(inputs.only_folder()))
