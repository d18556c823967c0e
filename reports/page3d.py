#!/usr/bin/python3
"""Makes the 3-D page of a run: one HTML file that opens from disk, without a network.

    reports/page3d.py FOLDER [-o FILE] [--most 50]      FOLDER/result.html

Run with --set output.frames_every=STEPS to see the hole grow; without it the page shows the end. A frame that cannot be
read is named and left out. Exit code 2 and one line on what is wrong when the folder is not one of `tdbd run`.
"""

import argparse
import base64
import colorsys
import io
import json
import sys
from pathlib import Path

import jinja2
import numpy as np
from markupsafe import Markup
from matplotlib.colors import Normalize, to_hex
from PIL import Image

import animate
import page3d_facts
import page3d_frames
from figures import bit_in_hole, render, rock_scene
from page3d_pack import Packer, grid, on_grid

HERE = Path(__file__).resolve().parent
SCRIPTS = ("unpack.js", "camera.js", "shaders.js", "meshes.js", "legend.js", "traces.js", "controls.js", "page3d.js")
DIGITS = 8  # of poses: a hundredth of a micron
STILL = 480  # pixels to a side of the picture for browsers that cannot draw
UNCUT, UNCUT_COLOUR = "not cut", "#b9b2a6"


def group_of(part):
    """A cutter of its face, chamfer and body; a row of its teeth."""
    return part.rsplit("/", 1)[0]


def groups(run, frames):
    """(names, number of each part's): of those that cut last somewhere; the first are all points that nothing cut."""
    parts = list(run["removed_volume_by_part_m3"])
    seen = np.unique(np.concatenate([f.rock.point_values["last_part"] for f in frames]).astype(int))
    if seen[-1] >= len(parts):
        raise ValueError(f"found a cut by part {seen[-1]}, expected one of the {len(parts)} of summary.json")
    names = [UNCUT, *dict.fromkeys(group_of(parts[k]) for k in seen[seen >= 0])]
    return names, np.array([names.index(group_of(p)) if group_of(p) in names else 0 for p in parts])


def last_groups(rock, group_of_part):
    """Of each point: 0 where nothing cut, or else the group that cut last."""
    last = rock.point_values["last_part"].astype(int)
    return np.where(last < 0, 0, group_of_part[last])


def packed_rock(frames, packer, group_of_part):
    """(box, entries of the header), one for each frame."""
    box = grid(np.concatenate([f.rock.points for f in frames]))
    entries, before = [], (None, None, None)
    for f in frames:
        arrays = on_grid(f.rock.points, *box), f.rock.triangles, last_groups(f.rock, group_of_part)
        changes = [packer.add(*pair) for pair in zip(arrays, before)]
        entries.append({"number": f.number, "time_s": f.time, "points": len(arrays[0]), "triangles": len(arrays[1]),
                        "changes": changes, "poses": [np.round(p, DIGITS).ravel().tolist() for p in f.poses]})
        before = arrays
    return box, entries


def packed_bit(bit, bodies, packer):
    """The header's entry: pieces of one body each; `hull` is what hides the bottom."""
    box, layer = grid(bit.points), bit_in_hole.bit_layer(bit)
    colours, colour = np.unique(layer.colours, axis=0, return_inverse=True)
    hull = (layer.colours == bit_in_hole.BODY).all(axis=1)
    body = bodies[bit.triangles[:, 0]]
    order = np.lexsort((np.arange(len(hull)), body, hull))
    packer.add(on_grid(bit.points, *box))
    packer.add(bit.triangles[order])
    packer.add(colour.ravel()[order])
    pieces = [{"hull": bool(h), "body": int(b), "triangles": int(((hull == h) & (body == b)).sum())}
              for h, b in dict.fromkeys(zip(hull[order], body[order]))]
    return {"box": boxed(box), "points": len(bit.points), "triangles": len(order), "pieces": pieces,
            "colours": [to_hex(c) for c in colours]}


def boxed(box):
    return {"origin": box[0].tolist(), "size": box[1].tolist()}


def group_colours(count):
    """As many hues, neighbours far apart: steps of the golden section."""
    return [to_hex(colorsys.hls_to_rgb((0.618034 * k) % 1.0, (0.42, 0.58, 0.70)[k % 3], 0.62)) for k in range(count)]


def depth_range(frames):
    """mm: of the bottoms at both ends of the run."""
    ends = [rock_scene.depth_norm(f.rock) for f in (frames[0], frames[-1])]
    return [float(min(n.vmin for n in ends)), float(max(n.vmax for n in ends))]


def colours(frames, names):
    ramp = [to_hex(c) for c in rock_scene.DEPTH(np.linspace(0, 1, 256))]
    return {"depth": {"ramp": ramp, "range_mm": depth_range(frames)},
            "part": {"names": names, "colours": [UNCUT_COLOUR, *group_colours(len(names) - 1)]},
            "quality": {"steps": rock_scene.QUALITY_STEPS.boundaries.tolist(),
                        "colours": [to_hex(c) for c in rock_scene.QUALITY.colors]}}


def still(frames, bit):
    """The end as a picture, for browsers that cannot draw: the address of an image that holds it."""
    last = frames[-1].rock
    low, high = depth_range(frames)
    camera = rock_scene.camera(last.points, rock_scene.INTO_HOLE, (STILL, STILL), dpi=1)
    image = Image.fromarray((255 * render.picture(camera, animate.scene(last, bit, Normalize(low, high)))).astype(np.uint8))
    file = io.BytesIO()
    image.quantize(64, dither=Image.Dither.NONE).save(file, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()


def in_script(value):
    """JSON that no HTML reader takes for the end of its element."""
    return Markup(json.dumps(value, separators=(",", ":")).replace("<", "\\u003c"))


def moved(bit, bodies, frame):
    """The bit where it is in a frame."""
    points = np.empty_like(bit.points)
    for k, pose in enumerate(frame.poses):
        points[bodies == k] = bit.points[bodies == k] @ pose[:, :3].T + pose[:, 3]
    return type(bit)(points, bit.triangles, bit.point_values, bit.cell_values)


def html_of(folder, most):
    """(page, frames). Raises ValueError."""
    run = page3d_facts.summary(folder)
    read = page3d_frames.read(folder, most)
    names, group_of_part = groups(run, read.found)
    packer = Packer()
    box, entries = packed_rock(read.found, packer, group_of_part)
    header = {"title": run["title"], "box": boxed(box), "frames": entries, "missing": read.missing,
              "bit": packed_bit(read.bit, read.bodies, packer), "colours": colours(read.found, names),
              "revolutions_per_s": run["revolutions"] / run["duration_s"] if run["duration_s"] else 0.0,
              "traces": page3d_facts.traces(folder)}
    case = folder / "case.toml"
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "web"), autoescape=True, trim_blocks=True,
                                     undefined=jinja2.StrictUndefined, lstrip_blocks=True)
    page = environment.get_template("page3d.html.j2").render(
        run=run, missing=read.missing, count=len(entries), header=in_script(header), data=base64.b64encode(packer.bytes()).decode(),
        facts=page3d_facts.facts(run), provenance=page3d_facts.provenance(run), diagnosis=page3d_facts.diagnosis(run),
        case=case.read_text(encoding="utf-8") if case.is_file() else "", still=still(read.found, moved(read.bit, read.bodies, read.found[-1])),
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
    print(f"page3d: {len(read.found)} frames, {path.stat().st_size / 1e6:.2f} MB; look at {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
