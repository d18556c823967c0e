"""Figure A.1: the bits together, each from the side and from below, to one scale."""

from figures import bit_data, bit_scene, render, style

INCHES = (2.4, 3.0)
SIDE = {"toward": (0.80, -0.60, 0.30), "up": (0, 0, -1)}


def draw(inputs):
    bits = [bit_data.read(folder) for folder in inputs.folders()]
    figure = style.Figure(figsize=(len(bits) * INCHES[0], 2 * INCHES[1]))
    for row, view in enumerate((SIDE, bit_scene.BELOW)):
        cameras = [bit_scene.camera(bit, view, INCHES, style.DPI) for bit in bits]
        width = max(c.width for c in cameras)
        for k, (bit, camera) in enumerate(zip(bits, cameras)):
            axes = figure.add_axes([k / len(bits), 0.48 * (1 - row), 1 / len(bits), 0.48])
            camera = render.Camera(camera.toward, camera.up, camera.centre, width, (camera.pixels[0], int(0.96 * camera.pixels[1])))
            bit_scene.show(axes, render.picture(camera, bit_scene.layer(bit)))
            if row == 0:
                figure.text((k + 0.5) / len(bits), 0.97, f"Bit {bit.name[-1].upper()}", weight="bold", fontsize=11, ha="center")
    return figure
