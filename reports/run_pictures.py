"""Pictures of a result folder of `tdbd run`: the bit, the hole from above and cut open, its cutters, forces and traces."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.patches import Rectangle

import result
from figures import bit_scene, drilling, hole_pictures, render, rock_data, rock_scene, style, traces

MM = 1e3
COLOURS = matplotlib.colormaps["Spectral"]
ZONES = {"cone": "#1b6ca8", "nose": "#2a9d5c", "shoulder": "#d98e04", "gage": "#b3382c"}
ABOVE = {"eye": np.array([0.0, 0.0, -1.0]), "light": np.array([-0.5, -0.5, -0.7])}
CUT = {"eye": np.array([0.0, 1.0, 0.0]), "light": np.array([-0.4, 0.5, -0.75])}
BOTTOM = 0.35  # a triangle belongs to the bottom, not to the wall, when |normal z| is above


def normals(surface, eye):
    """Unit normals of triangles, turned towards the eye."""
    n = surface.normals
    return np.where((n @ eye)[:, None] < 0.0, -n, n)


def on_bottom(surface):
    """Triangles of the bottom, as opposed to the wall of the hole."""
    return normals(surface, ABOVE["eye"])[:, 2] < -BOTTOM


def relief(surface, view):
    """Light on each triangle, 0 to 1, stretched to the contrast that the bottom has."""
    lit = normals(surface, view["eye"]) @ view["light"]
    low, high = np.percentile(lit[on_bottom(surface)], [1.0, 99.0])
    return ((lit - low) / max(high - low, 1e-12)).clip(0.0, 1.0)


def shaded_colours(surface, norm, view):
    """Depth in colour, darker in the shade and paler in the light."""
    colours = COLOURS(norm(MM * surface.of_triangles("depth_m")))
    shade = relief(surface, view)[:, None]
    rgb = colours[:, :3]
    dark, pale = rgb * (0.35 + 1.3 * shade), rgb + (1.0 - rgb) * (shade - 0.5)
    colours[:, :3] = np.where(shade < 0.5, dark, pale).clip(0.0, 1.0)
    return colours


def depth_scale(surface):
    """Colours span the depths of the bottom; the wall above has the end colour."""
    depth = MM * surface.of_triangles("depth_m")[on_bottom(surface)]
    return Normalize(*np.percentile(depth, [0.5, 100.0]))


def draw_triangles(ax, polygons, colours, order, edge="face", width=0.3):
    """Paints polygons back to front."""
    edges = colours[order] if isinstance(edge, str) and edge == "face" else edge
    ax.add_collection(
        PolyCollection(polygons[order], facecolors=colours[order], edgecolors=edges,
                       linewidths=width, rasterized=True)
    )


def add_depth_bar(figure, ax, norm):
    """The scale of depth, deeper downwards; the arrow marks the wall above."""
    bar = figure.colorbar(ScalarMappable(norm, COLOURS), ax=ax, shrink=0.8, pad=0.03, extend="min")
    bar.set_label("depth z (mm), down")
    bar.ax.invert_yaxis()


def caption(summary):
    """One line that names the run; every number comes from the summary."""
    name = summary.get("title") or "TDBD run"
    return f"{name}: {summary['revolutions']:.4g} revolutions, {summary['steps']} steps"


def bottom_hole(surface, summary):
    """The pattern seen from above the hole along +z: x to the right, hence y down the page."""
    figure, ax = style.panels(1, 1, (8.0, 6.8))
    norm = depth_scale(surface)
    polygons = MM * surface.corners[:, :, :2]
    colours = shaded_colours(surface, norm, ABOVE)
    draw_triangles(ax, polygons, colours, order=np.argsort(-surface.of_triangles("depth_m")))
    radius = 1.03 * MM * np.abs(surface.points[:, :2]).max()
    ax.set(xlim=(-radius, radius), ylim=(radius, -radius), aspect="equal",
           xlabel="x (mm)", ylabel="y (mm)")
    ax.grid(False)
    figure.suptitle(traces.fitted(f"Bottom hole from above\n{caption(summary)}", figure), fontsize=10)
    add_depth_bar(figure, ax, norm)
    return figure


def mesh_detail(ax, surface, norm):
    """Some 20 triangles' width of the mesh from above, half way out along -y."""
    corners = MM * surface.corners
    bottom = on_bottom(surface)
    edge = np.median(np.linalg.norm(corners[bottom, 1] - corners[bottom, 0], axis=1))
    y = -0.5 * np.abs(corners[:, :, 1]).max()
    draw_triangles(ax, corners[:, :, :2], shaded_colours(surface, norm, ABOVE),
                   np.argsort(-surface.of_triangles("depth_m")), edge=(0, 0, 0, 0.8), width=0.4)
    half = 10.0 * edge
    ax.set(xlim=(-half, half), ylim=(y + half, y - half), aspect="equal", xlabel="x (mm)",
           ylabel="y (mm)", title="Mesh from above")


def side_view(surface, summary):
    """The half y < 0, seen along -y from the cut: x to the right, z down; and the mesh of a detail."""
    keep = surface.corners[:, :, 1].max(axis=1) <= 1e-9
    half = rock_data.Mesh(surface.points, surface.triangles[keep], surface.point_values)
    figure, (ax, detail) = style.panels(1, 2, (11.0, 4.6), width_ratios=[2.0, 1.0])
    norm = depth_scale(surface)
    order = np.argsort(half.corners[:, :, 1].mean(axis=1))
    draw_triangles(ax, MM * half.corners[:, :, [0, 2]], shaded_colours(half, norm, CUT), order,
                   edge=(0, 0, 0, 0.35), width=0.12)
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="z (mm)")
    figure.suptitle(traces.fitted(f"Half of the hole, cut at y = 0\n{caption(summary)}", figure), fontsize=10)
    ax.grid(False)
    detail.grid(False)
    ax.autoscale_view()
    ax.invert_yaxis()
    mesh_detail(detail, surface, norm)
    add_depth_bar(figure, detail, norm)
    return figure


BAR = 0.6  # mm: narrower than the cutters' spacing on the shoulder


def same_radius(cutters):
    """Runs of cutters (they are sorted) at the same tip radius, as those at the gage are."""
    runs = []
    for i, cutter in enumerate(cutters):
        if runs and MM * (cutter.tip_radius - cutters[runs[-1][0]].tip_radius) < 0.01:
            runs[-1].append(i)
        else:
            runs.append([i])
    return runs


def number(cutter):
    return cutter.name.rsplit("-", 1)[-1]


NEAR = (2.5, 0.055)  # mm, and share of the highest bar: labels closer than both would overlap


def merged_labels(tops, highest):
    """Places of labels; one that would overlap the label before it shares its place."""
    labels = []
    for place, top, first, last in tops:
        if labels and place - labels[-1][0] < NEAR[0] and abs(top - labels[-1][1]) < NEAR[1] * highest:
            labels[-1] = (*labels[-1][:3], last)
        else:
            labels.append((place, top, first, last))
    return labels


def draw_bars(ax, cutters, values, label):
    """A bar for each cutter at its tip radius, coloured by zone, with its number; cutters at one
    radius stand on each other."""
    tops = []  # (place, height, first cutter, last cutter)
    for run in same_radius(cutters):
        place, top = MM * cutters[run[0]].tip_radius, 0.0
        for i in run:
            ax.bar(place, values[i], BAR, bottom=top, color=ZONES.get(cutters[i].zone, "0.5"),
                   edgecolor="white", linewidth=0.2)
            top += values[i]
        tops.append((place, top, run[0], run[-1]))
    for place, top, first, last in merged_labels(tops, max(values)):
        text = number(cutters[first]) + (f"-{number(cutters[last])}" if last > first else "")
        ax.annotate(text, (place, top), xytext=(2.0, 0.0), textcoords="offset points", ha="left",
                    va="bottom" if top > 0.1 * max(values) else "center", fontsize=6, color="0.3")
    ax.set_ylabel(label)
    ax.grid(axis="y", color="0.9")
    ax.set_axisbelow(True)
    ax.spines[["top", "right"]].set_visible(False)


def cutter_bars(cutters, summary):
    """What each cutter removed in the last full revolution, and its mean cut area V / (2 pi r)."""
    last = max(result.full_revolutions(summary), 1)
    volumes = np.array([c.volumes[last - 1] if len(c.volumes) >= last else 0.0 for c in cutters])
    areas = volumes / (2.0 * np.pi * np.array([max(c.tip_radius, 1e-9) for c in cutters]))
    figure, (top, bottom) = style.panels(2, 1, (8.0, 6.0), sharex=True)
    draw_bars(top, cutters, MM**3 * volumes, "volume per revolution (mm$^3$)")
    draw_bars(bottom, cutters, MM**2 * areas, "mean cut area (mm$^2$)")
    bottom.set_xlabel("tip radius (mm)")
    figure.suptitle(traces.fitted(f"Cutters in revolution {last}\n{caption(summary)}", figure), fontsize=10)
    zones = [z for z in ZONES if any(c.zone == z for c in cutters)]
    top.legend([Rectangle((0, 0), 1, 1, color=ZONES[z]) for z in zones], zones,
               frameon=False, ncol=4, loc="upper left")
    top.margins(y=0.22)
    return figure


INCHES_OF_BIT = (4.4, 4.4)


def bit_views(folder, summary):
    """The bit at the end of a run, from below and from the side."""
    mesh = rock_data.final(folder, "bit")
    layer = hole_pictures.bit_layer(mesh)
    figure, frames = bit_scene.canvas(2, INCHES_OF_BIT)
    for axes, view, words in zip(frames, (bit_scene.BELOW, bit_scene.ISOMETRIC), ("from below", "from the side")):
        camera = rock_scene.camera(mesh.points, view, INCHES_OF_BIT, dpi=style.DPI)
        bit_scene.show(axes, render.picture(camera, layer))
        axes.text(0.02, 0.98, words, transform=axes.transAxes, va="top", fontsize=9)
    return figure


def forces(summary):
    """Forces and power of every cutter."""
    figure = drilling.draw_summary(summary)
    figure.suptitle(traces.fitted(f"Mean forces of the cutters\n{caption(summary)}", figure), fontsize=10)
    return figure


def pictures(folder, summary):
    """[(name, title, caption, function that draws it)] of a run. Raises ValueError if its folder has no surface of the rock."""
    made, words = [], caption(summary)
    if (folder / "frames" / "bit_final.vtp").is_file():
        made.append(("bit", "The bit", "At the end of the run.", lambda: bit_views(folder, summary)))
    surface = result.read_surface(folder / "frames" / "rock_final.vtp")
    made.append(("bottom_hole", "The bottom of the hole", "From above, along the hole: x to the right, y down. The colour is depth; light "
                 "comes from the upper left.", lambda: bottom_hole(surface, summary)))
    made.append(("side_view", "The hole from the side", "Left: the half behind the plane y = 0. Right: the mesh of a detail from above.",
                 lambda: side_view(surface, summary)))
    if (folder / "bit.json").is_file():
        cutters = result.read_cutters(folder, summary)
        if cutters:
            made.append(("cutters", "Rock removed by each cutter", "Above: volume in the last full revolution. Below: mean cut area, which "
                         "is the volume over the length of the tip's circle.", lambda: cutter_bars(cutters, summary)))
    if any(part["name"].startswith("cutter-") for part in summary.get("forces", [])):
        made.append(("forces", "Forces and power of each cutter", "Means over the time for which the summary has means.",
                     lambda: forces(summary)))
    if (folder / "history.nc").is_file():
        diagnosis = (summary.get("diagnosis") or {}).get("text", "at a given rate of penetration")
        made.append(("traces", "Traces", "One quantity to a panel. A straight line in the middle of its panel is a constant.",
                     lambda: traces.draw_folder(folder, f"{words}\n{diagnosis}")))
    return made
