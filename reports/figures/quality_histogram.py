"""Ours, of 4.2.4.4: the shape quality of the rock's triangles at the beginning, in the middle and at the end of runs."""

import numpy as np

from figures import results, rock_data, style

BINS = np.linspace(0, 1, 51)


def draw(inputs):
    folders = inputs.folders()
    figure, frames = style.panels(1, len(folders), (4.8 * len(folders), 3.4), sharey=True, squeeze=False)
    for axes, folder in zip(frames[0], folders):
        run, made = results.summary(folder), rock_data.frames(folder)
        for (time, path), colour in zip((made[0], made[len(made) // 2], made[-1]), (style.GREY, style.SKY, style.RED)):
            quality = rock_data.read(path).cell_values["quality"]
            turns = run["revolutions"] * time / run["duration_s"]
            axes.hist(quality, BINS, weights=np.full(len(quality), 100 / len(quality)), histtype="step", linewidth=1.4,
                      color=colour, label=f"{turns:.0f} revolutions, {len(quality)} triangles")
        axes.set(yscale="log", xlim=(0, 1), xlabel="shape quality, 1: equilateral", title=run["title"])
        axes.legend(loc="upper left")
    frames[0][0].set_ylabel("share of triangles (%), bins of 0.02")
    return figure
