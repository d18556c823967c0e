#!/usr/bin/python3
"""Draws a TDBD result folder, of tdbd run, tdbd string or tdbd converge.

    reports/draw.py RESULT_FOLDER [-o DIR]

Of a run: bottom_hole.png and side_view.png (from frames/rock_final.vtp and summary.json), cutters.png (also
from bit.json); with forces: forces.png shows those of every cutter, traces.png weight, torque and speed over
time with their spectra. Of a drill string: torque_and_drag.png, broomstick.png, modes.png, and of a run traces.png
and time_depth.png. Of a study of convergence: convergence.png (from convergence.json).
"""

import argparse
from pathlib import Path

import system_python

system_python.require("matplotlib", "numpy")

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

import result
from figures import rock_data

MM = 1e3
COLOURS = plt.get_cmap("Spectral")
ZONES = {"cone": "#1b6ca8", "nose": "#2a9d5c", "shoulder": "#d98e04", "gage": "#b3382c"}
ABOVE = {"eye": np.array([0.0, 0.0, -1.0]), "light": np.array([-0.5, -0.5, -0.7])}
CUT = {"eye": np.array([0.0, 1.0, 0.0]), "light": np.array([-0.4, 0.5, -0.75])}
BOTTOM = 0.35  # a triangle belongs to the bottom, not to the wall, when |normal z| is above
plt.rcParams.update({"font.size": 9, "axes.titlesize": 10, "savefig.dpi": 200})


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


def sign(figure, summary):
    """Small print: what made the numbers."""
    origin = f"tdbd {summary.get('version', '?')} {summary.get('commit', '?')}"
    figure.text(0.995, 0.005, f"{origin}, case {str(summary.get('case_hash', '?'))[:12]}",
                ha="right", va="bottom", fontsize=6, color="0.5")


def bottom_hole(surface, summary, path):
    """The pattern seen from above the hole along +z: x to the right, hence y down the page."""
    figure, ax = plt.subplots(figsize=(8.0, 6.8), constrained_layout=True)
    norm = depth_scale(surface)
    polygons = MM * surface.corners[:, :, :2]
    colours = shaded_colours(surface, norm, ABOVE)
    draw_triangles(ax, polygons, colours, order=np.argsort(-surface.of_triangles("depth_m")))
    radius = 1.03 * MM * np.abs(surface.points[:, :2]).max()
    ax.set(xlim=(-radius, radius), ylim=(radius, -radius), aspect="equal",
           xlabel="x (mm)", ylabel="y (mm)",
           title=f"Bottom hole from above\n{caption(summary)}")
    add_depth_bar(figure, ax, norm)
    finish(figure, summary, path)


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


def side_view(surface, summary, path):
    """The half y < 0, seen along -y from the cut: x to the right, z down; and the mesh of a detail."""
    keep = surface.corners[:, :, 1].max(axis=1) <= 1e-9
    half = rock_data.Mesh(surface.points, surface.triangles[keep], surface.point_values)
    figure, (ax, detail) = plt.subplots(1, 2, figsize=(11.0, 4.6), constrained_layout=True,
                                        gridspec_kw={"width_ratios": [2.0, 1.0]})
    norm = depth_scale(surface)
    order = np.argsort(half.corners[:, :, 1].mean(axis=1))
    draw_triangles(ax, MM * half.corners[:, :, [0, 2]], shaded_colours(half, norm, CUT), order,
                   edge=(0, 0, 0, 0.35), width=0.12)
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="z (mm)",
           title=f"Half of the hole, cut at y = 0\n{caption(summary)}")
    ax.autoscale_view()
    ax.invert_yaxis()
    mesh_detail(detail, surface, norm)
    add_depth_bar(figure, detail, norm)
    finish(figure, summary, path)


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


def draw_bars(ax, cutters, values, label):
    """A bar for each cutter at its tip radius, coloured by zone, with its number; cutters at one
    radius stand on each other."""
    for run in same_radius(cutters):
        place, top = MM * cutters[run[0]].tip_radius, 0.0
        for i in run:
            ax.bar(place, values[i], BAR, bottom=top, color=ZONES.get(cutters[i].zone, "0.5"),
                   edgecolor="white", linewidth=0.2)
            top += values[i]
        text = number(cutters[run[0]]) + (f"-{number(cutters[run[-1]])}" if run[1:] else "")
        ax.annotate(text, (place, top), xytext=(2.0, 0.0), textcoords="offset points", ha="left",
                    va="bottom" if top > 0.1 * max(values) else "center", fontsize=6, color="0.3")
    ax.set_ylabel(label)
    ax.grid(axis="y", color="0.9")
    ax.set_axisbelow(True)
    ax.spines[["top", "right"]].set_visible(False)


def cutter_bars(cutters, summary, path):
    """What each cutter removed in the last full revolution, and its mean cut area V / (2 pi r)."""
    last = max(result.full_revolutions(summary), 1)
    volumes = np.array([c.volumes[last - 1] if len(c.volumes) >= last else 0.0 for c in cutters])
    areas = volumes / (2.0 * np.pi * np.array([max(c.tip_radius, 1e-9) for c in cutters]))
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(8.0, 6.0), sharex=True,
                                         constrained_layout=True)
    draw_bars(top, cutters, MM**3 * volumes, "volume per revolution (mm$^3$)")
    draw_bars(bottom, cutters, MM**2 * areas, "mean cut area (mm$^2$)")
    bottom.set_xlabel("tip radius (mm)")
    top.set_title(f"Cutters in revolution {last}\n{caption(summary)}")
    zones = [z for z in ZONES if any(c.zone == z for c in cutters)]
    top.legend([plt.Rectangle((0, 0), 1, 1, color=ZONES[z]) for z in zones], zones,
               frameon=False, ncol=4, loc="upper left")
    top.margins(y=0.22)
    finish(figure, summary, path)


def finish(figure, summary, path):
    """Signs and saves a figure, with nothing in the file that depends on the date."""
    sign(figure, summary)
    figure.savefig(path, metadata={"Software": None})
    plt.close(figure)
    print(path)


def force_pictures(folder, summary, output):
    """Forces of the cutters, if the bit has some, and the traces of the run."""
    from figures import drilling  # here: their style is not this file's

    if any(part["name"].startswith("cutter-") for part in summary["forces"]):
        finish(drilling.draw_summary(summary), summary, output / "forces.png")
    words = summary.get("diagnosis", {}).get("text", "at a given rate of penetration")
    finish(drilling.draw_folder(folder, f"{caption(summary)}\n{words}"), summary, output / "traces.png")


def run_pictures(folder, output):
    """All pictures of a result of tdbd run."""
    summary = result.read_json(folder / "summary.json")
    surface = result.read_surface(folder / "frames" / "rock_final.vtp")
    bottom_hole(surface, summary, output / "bottom_hole.png")
    side_view(surface, summary, output / "side_view.png")
    if (folder / "bit.json").is_file():
        cutter_bars(result.read_cutters(folder, summary), summary, output / "cutters.png")
    if "forces" in summary:
        force_pictures(folder, summary, output)


def study_picture(folder, output):
    """The errors of a study of tdbd converge."""
    from figures import convergence

    study = result.read_json(folder / "convergence.json")
    finish(convergence.draw_folder(folder), study, output / "convergence.png")


def string_pictures(folder, output):
    """All pictures of a result of tdbd string."""
    from figures import string_pictures as pictures

    figures, summary = pictures.pictures(folder)
    for name, figure in figures.items():
        finish(figure, summary, output / f"{name}.png")


def is_of_string(folder):
    summary = folder / "summary.json"
    return summary.is_file() and result.read_json(summary).get("command") == "string"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="result folder of tdbd run, tdbd string or tdbd converge")
    parser.add_argument("-o", "--output", type=Path, help="where figures go (the result folder)")
    arguments = parser.parse_args()
    output = arguments.output or arguments.folder
    output.mkdir(parents=True, exist_ok=True)
    if (arguments.folder / "convergence.json").is_file():
        study_picture(arguments.folder, output)
    elif is_of_string(arguments.folder):
        string_pictures(arguments.folder, output)
    else:
        run_pictures(arguments.folder, output)


if __name__ == "__main__":
    main()
