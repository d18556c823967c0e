"""Figures 3.9 and 3.10: meshes of a cutter's face and chamfer, and of a row of teeth."""

import numpy as np

from figures import bit_data, bit_scene, render, style

INCHES = (3.6, 3.6)


def cutter_mesh(axes, bit, dpi):
    """Face and chamfer of the cutter in the middle of the table, seen along its axis."""
    k = len(bit.cutters) // 2
    one = bit.cutters[k]
    layer = render.joined([bit_scene.layer(bit, lambda p: p["cutter"] == k and p["kind"] == kind, colour, True)
                           for kind, colour in (("face", "#a9c6e3"), ("chamfer", "#e3c9a0"))])
    view = {"toward": tuple(one["x_axis"]), "up": tuple(-np.array(one["z_axis"]))}
    camera = bit_scene.camera(bit, view, INCHES, dpi, 0.54 * one["diameter_m"], one["face_centre_m"])
    bit_scene.show(axes, render.picture(camera, layer))


def draw_cutters(bits, dpi=style.DPI):
    figure, frames = bit_scene.canvas(len(bits), INCHES)
    for axes, bit in zip(frames, bits):
        cutter_mesh(axes, bit, dpi)
        axes.text(0.02, 0.98, f"{bit.name}", transform=axes.transAxes, va="top", fontsize=10, weight="bold")
    return figure


def draw_teeth(bit, dpi=style.DPI):
    """The first cone from its side, and the meshes of its visible teeth."""
    figure, frames = bit_scene.canvas(2, INCHES)
    cone = bit.cones[0]
    axis, origin = np.array(cone["axis"]), np.array(cone["origin_m"])
    toward = render.unit(np.cross(axis, [0.0, 0.0, 1.0])) - 0.35 * axis
    teeth = [p for p in bit.parts if p["cone"] == 0 and p["kind"] == "tooth"]
    places = np.array([p["origin_m"] for p in teeth])
    out = places - origin - np.outer((places - origin) @ axis, axis)
    seen = {p["name"] for p, o in zip(teeth, out) if o @ toward > -0.1 * np.linalg.norm(o)}
    view = {"toward": tuple(toward), "up": tuple(np.cross(axis, toward))}
    camera = bit_scene.camera(bit, view, INCHES, dpi, 0.62 * np.ptp(places, axis=0).max(), places.mean(axis=0))
    bit_scene.show(frames[0], render.picture(camera, bit_scene.layer(bit, lambda p: p["cone"] == 0)))
    meshes = bit_scene.layer(bit, lambda p: p["name"] in seen, "#d9a3a0", True)
    bit_scene.show(frames[1], render.picture(camera, meshes))
    return figure


def draw(inputs):
    bits = [bit_data.read(folder) for folder in inputs.folders()]
    return draw_teeth(bits[0]) if bits[0].cones else draw_cutters(bits)
