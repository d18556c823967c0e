#!/usr/bin/python3
"""Makes a moving picture of a hole being drilled, from the frames of a run.

    reports/animate.py RESULT_FOLDER OUT.gif [--pixels 400] [--seconds 5]

Needs rock.pvd with its frames and bit_poses.csv: run with --set output.frames_every=STEPS. `tdbd draw FOLDER --gif OUT.gif` calls it.
"""

import argparse
import sys
from pathlib import Path

import system_python

system_python.require("matplotlib", "numpy", "PIL")

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.font_manager import findfont
from PIL import Image, ImageDraw, ImageFont

from figures import bit_motion, hole_pictures, render, results, rock_data, rock_scene
from progress import Progress

COLOURS = 64  # of the whole picture: a GIF has 256 at most, and fewer are smaller
INK = (29, 39, 51)


def cutting_parts(bit):
    """Without the body, which would hide the bottom."""
    parts = hole_pictures.bit_layer(bit)
    return hole_pictures.part_of(parts, (parts.colours != hole_pictures.BODY).any(axis=1))


def scene(rock, bit, norm):
    return render.joined([rock_scene.layer(rock, rock_scene.by_depth(rock, norm)), cutting_parts(bit)])


def frames(folder):
    """[(time, file of the rock, poses of the bit's bodies)] of a run; s."""
    return [(time, rock, poses) for (time, rock), (_, poses) in zip(rock_data.frames(folder), bit_motion.poses(folder))]


def camera_of(bit, last, pixels):
    """Sees the bit at the start and the hole at the end, so that nothing but the bit moves."""
    points = np.concatenate([rock_data.read(last[1]).points, cutting_parts(bit).corners.reshape(-1, 3)])
    return rock_scene.camera(points, rock_scene.INTO_HOLE, (pixels, pixels), dpi=1, margin=1.06)


def picture(rock, bit, camera, norm, words):
    image = render.picture(camera, scene(rock, bit, norm))
    drawn = Image.fromarray((255 * image).astype(np.uint8))
    ImageDraw.Draw(drawn).text((8, drawn.height - 38), words, fill=INK, font=ImageFont.truetype(findfont("DejaVu Sans"), 13))
    return drawn


def animate(folder, out, pixels=400, seconds=5.0):
    """Writes the picture. Raises ValueError when the run has no frames."""
    run, made = results.summary(folder), frames(folder)
    if len(made) < 2:
        raise ValueError(f"{folder}: found {len(made)} frame, expected several; run with --set output.frames_every=STEPS")
    depths = [1e3 * rock_data.read(made[k][1]).point_values["depth_m"].max() for k in (0, -1)]
    rest = bit_motion.at_rest(rock_data.final(folder, "bit"), made[-1][2])
    norm, camera = Normalize(*depths), camera_of(bit_motion.placed(*rest, made[0][2]), made[-1], pixels)
    images = []
    for time, rock, poses in Progress("animate", len(made), "frame").over(made, lambda frame: f"t = {frame[0]:.3g} s"):
        words = (f"{run['title']}: {run['revolutions'] * time / run['duration_s']:.1f} revolutions\n"
                 f"depth z: yellow {depths[0]:.0f} mm and less, blue {depths[1]:.0f} mm")
        images.append(picture(rock_data.read(rock), bit_motion.placed(*rest, poses), camera, norm, words))
    palette = images[-1].quantize(COLOURS)
    few = [i.quantize(palette=palette, dither=Image.Dither.NONE) for i in images]
    few[0].save(out, save_all=True, append_images=few[1:], duration=int(1000 * seconds / len(few)), loop=0, optimize=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="result folder of tdbd run")
    parser.add_argument("out", type=Path, help="the picture, .gif")
    parser.add_argument("--pixels", type=int, default=400, help="to a side (400)")
    parser.add_argument("--seconds", type=float, default=5.0, help="length (5)")
    chosen = parser.parse_args()
    try:
        animate(chosen.folder, chosen.out, chosen.pixels, chosen.seconds)
    except (OSError, ValueError) as error:
        print(f"animate.py: {error}", file=sys.stderr)
        return 2
    print(chosen.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
