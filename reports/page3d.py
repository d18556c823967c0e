#!/usr/bin/python3
"""Makes the 3-D page of a run: one HTML file that opens from disk, without a network.

    reports/page3d.py FOLDER [-o FILE] [--most 50]      FOLDER/result.html

Run with --set output.frames_every=STEPS to see the hole grow; without it the page shows the end. A frame that cannot be
read is named and left out. Exit code 2 and one line with the reason when the folder is not one of `tdbd run`.
"""

import argparse
import base64
import io
import json
import sys
from pathlib import Path

import system_python

system_python.require("jinja2", "matplotlib", "numpy", "PIL")

import jinja2
import numpy as np
from markupsafe import Markup
from matplotlib.colors import Normalize
from PIL import Image

import animate
import page3d_pack as pack
import page3d_parts as of_parts
import page3d_run as of_run
import page3d_scene as scene
from figures import bit_motion, render, rock_scene

HERE = Path(__file__).resolve().parent
SCRIPTS = ("unpack.js", "camera.js", "shaders.js", "meshes.js", "draw.js", "legend.js", "traces.js", "controls.js", "pick.js",
           "scene.js", "parts.js", "page3d.js")
STILL = 480  # pixels to a side of the picture for browsers that cannot draw


def still(frames, bit):
    """The end as a picture, for browsers that cannot draw: a data URL."""
    last = frames[-1].rock
    low, high = scene.depth_range(frames)
    camera = rock_scene.camera(last.points, rock_scene.INTO_HOLE, (STILL, STILL), dpi=1)
    image = Image.fromarray((255 * render.picture(camera, animate.scene(last, bit, Normalize(low, high)))).astype(np.uint8))
    file = io.BytesIO()
    image.quantize(64, dither=Image.Dither.NONE).save(file, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()


def in_script(value):
    """JSON in which no HTML reader finds the end of its element."""
    return Markup(json.dumps(value, separators=(",", ":")).replace("<", "\\u003c"))


def html_of(folder, most):
    """(page, frames). Raises ValueError."""
    run = of_run.summary(folder)
    read = of_run.read_frames(folder, most)
    names, group_of_part = scene.groups(run, read.found)
    box, entries, parts = scene.packed_rock(read.found, group_of_part)
    numbers, of_groups = of_parts.groups(folder, run)
    bit, bit_part = scene.packed_bit(read.bit, read.bodies, scene.areas_of_bit(folder), [numbers[of_parts.group_of(p)] for p in run["removed_volume_by_part_m3"]])
    header = {"title": run["title"], "box": scene.boxed(box), "frames": entries, "missing": read.missing, "listed": read.listed,
              "bit": bit, "colours": scene.colours(read.found, names),
              "revolutions_per_s": run["revolutions"] / run["duration_s"] if run["duration_s"] else 0.0,
              "parts": of_groups, "traces": of_run.traces(folder)}
    case = folder / "case.toml"
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "web"), autoescape=True, trim_blocks=True,
                                     undefined=jinja2.StrictUndefined, lstrip_blocks=True)
    page = environment.get_template("page3d.html.j2").render(
        run=run, missing=read.missing, count=len(entries), areas="areas" in bit, header=in_script(header), data=base64.b64encode(pack.deflated([*parts, bit_part])).decode(),
        facts=of_run.facts(run), no_traces=of_run.why_no_traces(folder, header["traces"]), part_names=[g["name"] for g in of_groups],
        forces=any(g["normal_n"] for g in of_groups),
        means=of_run.means_words(run), provenance=of_run.provenance(run), diagnosis=of_run.diagnosis(run),
        case=case.read_text(encoding="utf-8") if case.is_file() else "", still=still(read.found, bit_motion.placed(read.bit, read.bodies, read.found[-1].poses)),
        style=Markup((HERE / "web/page3d.css").read_text(encoding="utf-8")),
        script=Markup("\n".join((HERE / "web" / name).read_text(encoding="utf-8") for name in SCRIPTS)))
    return page, read


def write(folder, path, most=50):
    """Writes the page, whole or not at all; returns the frames. Raises ValueError."""
    page, read = html_of(Path(folder), most)
    partial = Path(f"{path}.partial")
    partial.parent.mkdir(parents=True, exist_ok=True)
    partial.write_text(page, encoding="utf-8")
    partial.rename(path)
    return read


def positive(word):
    if not word.isdigit() or int(word) < 1:
        raise argparse.ArgumentTypeError(f"found {word!r}, expected a whole number from 1")
    return int(word)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=Path, help="result folder of `tdbd run`")
    parser.add_argument("-o", "--output", type=Path, help="the page (FOLDER/result.html)")
    parser.add_argument("--most", type=positive, default=50, help="frames at most, evenly spread (50)")
    chosen = parser.parse_args(arguments)
    path = chosen.output or chosen.folder / "result.html"
    try:
        read = write(chosen.folder, path, chosen.most)
    except (OSError, ValueError) as error:
        print(f"page3d: {error}", file=sys.stderr)
        return 2
    for lost in read.missing:
        print(f"page3d: left out frame {lost['number']}: {lost['why']}", file=sys.stderr)
    shown = len(read.found)
    frames = f"{shown} frame{'s' * (shown != 1)}" if shown == read.listed else f"{shown} of the {read.listed} frames of the run (--most {chosen.most})"
    print(f"page3d: {frames}, {path.stat().st_size / 1e6:.2f} MB; look at {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
