"""The rock as a scene: depth or shape quality in colour, seen from above, from the side, from below."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, ListedColormap, Normalize

from figures import bit_scene, render

MM = 1e3
DPI = 110  # of pictures of many triangles: enough for their edges, and soon drawn
DEPTH = ListedColormap(matplotlib.colormaps["viridis_r"](np.linspace(0.0, 0.8, 256)))  # dark ends hide the relief
# Good triangles are pale, so that the mesh's lines show.
QUALITY = ListedColormap(["#7f0000", "#d7301f", "#fc8d59", "#fdbb84", "#fdd9a8", "#cfe3ef", "#f2f7fb"])
QUALITY_STEPS = BoundaryNorm([0.0, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 1.0], QUALITY.N)
# x to the right in all; y down the picture from above, up it from below; z down from the side.
ABOVE = {"toward": (0, 0, -1), "up": (0, -1, 0)}
BELOW = {"toward": (0, 0, 1), "up": (0, 1, 0)}
SIDE = {"toward": (0, 1, 0), "up": (0, 0, -1)}
INTO_HOLE = {"toward": (0.35, 0.85, -0.42), "up": (0, 0, -1)}
BOTTOM = 0.35  # a triangle is of the bottom, not of the wall, when -z of its normal is more


def depth_norm(mesh):
    """From the highest to the lowest place of the bottom, mm; the wall has the colour of the end."""
    bottom = mesh.normals[:, 2] < -BOTTOM
    return Normalize(*np.percentile(MM * mesh.of_triangles("depth_m")[bottom], [0.5, 100.0]))


def layer(mesh, colours):
    """One layer of render. The rock's triangles face the hole and are not drawn from behind, so that the
    nearer wall is transparent."""
    return render.Layer(mesh.corners, np.asarray(colours)[:, :3], np.zeros(len(mesh.triangles), int))


def layer_from_rock(mesh, colours, view):
    """The same seen from the rock, with the triangles' edges, and in even light, so that colours can be read."""
    turned = render.Layer(mesh.corners[:, ::-1], np.asarray(colours)[:, :3], np.zeros(len(mesh.triangles), int), True)
    turned.normals = render.unit(turned.normals + 2.0 * render.unit(view["toward"]))
    return turned


def by_depth(mesh, norm):
    return DEPTH(norm(MM * mesh.of_triangles("depth_m")))


def by_quality(mesh):
    return QUALITY(QUALITY_STEPS(mesh.cell_values["quality"]))


def camera(points, view, inches, dpi=DPI, margin=1.04):
    """Looks at all of these points."""
    pixels = tuple(int(round(dpi * x)) for x in inches)
    axes = render.Camera(centre=(0, 0, 0), width=1.0, pixels=pixels, **view).axes()
    seen = points @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width = margin * max(high[0] - low[0], (high[1] - low[1]) * pixels[0] / pixels[1])
    return render.Camera(centre=tuple(0.5 * (low + high) @ axes), width=width, pixels=pixels, **view)


def show(axes, camera, image):
    """A picture in millimetres of the plane that it is seen in; for views along an axis of space."""
    right, up = camera.axes()[:2]
    middle = MM * np.array([np.dot(camera.centre, right), np.dot(camera.centre, up)])
    half = MM * 0.5 * camera.width * np.array([1.0, camera.pixels[1] / camera.pixels[0]])
    left_right = (middle[0] - half[0], middle[0] + half[0])
    signs = np.sign(right.sum()), np.sign(up.sum())
    low_high = (middle[1] - half[1], middle[1] + half[1])
    extent = [signs[0] * x for x in left_right] + [signs[1] * y for y in low_high]
    axes.imshow(image, extent=extent, interpolation="antialiased", aspect="equal")
    names = [("x", "y", "z")[np.argmax(np.abs(v))] for v in (right, up)]
    axes.set(xlabel=f"{names[0]} (mm)", ylabel=f"{names[1]} (mm)")
    axes.grid(False)


def show_free(axes, image):
    """A picture in an oblique view, without axes."""
    bit_scene.show(axes, image)


def depth_bar(figure, axes, norm):
    bar = figure.colorbar(ScalarMappable(norm, DEPTH), ax=axes, shrink=0.75, pad=0.02, extend="min")
    bar.set_label("depth z (mm), down; the wall above has the colour of the end")
    bar.ax.invert_yaxis()


def quality_bar(figure, axes):
    bar = figure.colorbar(ScalarMappable(QUALITY_STEPS, QUALITY), ax=axes, shrink=0.75, pad=0.02,
                          ticks=QUALITY_STEPS.boundaries)
    bar.set_label("shape quality of a triangle, 1: equilateral")
