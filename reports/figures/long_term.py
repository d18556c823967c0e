"""Ours, of section 4.4.2: mesh and hole over many revolutions."""

import numpy as np

from figures import results, rock_data, style

COLOURS = (style.BLUE, style.RED, style.GREEN, style.PURPLE)


def over_frames(folder):
    """(revolutions, worst quality, quality that 99 % exceed, share above 0.5) of every frame."""
    run = results.summary(folder)
    turns = run["revolutions"] / run["duration_s"]
    rows = []
    for time, path in rock_data.frames(folder):
        quality = rock_data.read(path).cell_values["quality"]
        rows.append((turns * time, quality.min(), np.quantile(quality, 0.01), (quality > 0.5).mean()))
    return np.array(rows).T


def draw_run(frames, folder, colour):
    run = results.summary(folder)
    turns, worst, low, _ = over_frames(folder)
    frames[0].plot(turns, worst, "o-", color=colour, label=f"{run['title']}: worst")
    frames[0].plot(turns, low, "--", color=colour, label=f"{run['title']}: 1 % quantile")
    angle, triangles = results.history(folder, "rotation_angle", "rock_triangles")
    frames[1].plot(np.abs(angle) / (2 * np.pi), triangles / run["rock_triangles_start"], color=colour, label=run["title"])
    volumes = np.array(run["removed_volume_by_revolution_m3"])[:int(run["revolutions"] + 1e-9)]
    depth, = results.history(folder, "position_z")
    whole = np.pi * run["gage_radius_m"]**2 * depth[-1] / run["revolutions"]
    frames[2].plot(1 + np.arange(len(volumes)), volumes / whole, color=colour, label=run["title"])


def draw(inputs):
    figure, frames = style.panels(1, 3, (11.0, 3.6))
    for folder, colour in zip(inputs.folders(), COLOURS):
        draw_run(frames, folder, colour)
    frames[0].set(xlabel="revolutions", ylabel="quality of triangles", ylim=(0, 1))
    frames[1].set(xlabel="revolutions", ylabel="triangles over those at the start")
    frames[2].set(xlabel="revolution", ylabel="volume removed over pi R$^2$ d")
    for axes in frames:
        axes.legend()
    return figure
