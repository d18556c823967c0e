#!/usr/bin/python3
"""Puts the program for browsers and its page into one HTML file that opens from disk.

    web/make.py FOLDER -o tdbd.html      FOLDER holds tdbd.js and tdbd.wasm, as scripts/web builds them
"""

import argparse
import base64
import io
import json
import subprocess
import sys
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.insert(0, str(ROOT / "reports"))

import system_python  # noqa: E402

system_python.require("jinja2", "matplotlib", "numpy", "PIL")

import jinja2  # noqa: E402
import page3d_parts  # noqa: E402
import page3d_scene  # noqa: E402
from figures import bit_scene, rock_scene  # noqa: E402
from markupsafe import Markup  # noqa: E402
from matplotlib.colors import to_hex  # noqa: E402
from PIL import Image  # noqa: E402

BITS = ("bit-a.toml", "bit-a.csv", "bit-b.toml", "bit-b.csv", "bit-c.toml", "bit-c.csv", "bit-r.toml", "bit-m.toml")
SHARED = ("unpack.js", "camera.js", "shaders.js", "meshes.js", "draw.js", "legend.js", "traces.js", "controls.js", "scene.js")
OWN = ("case_text.js", "case_zip.js", "volumes.js", "live_traces.js", "live_scene.js", "drive.js")
STILL = 480  # pixels to a side of the picture for browsers that cannot draw


def looks():
    """The colours of the pictures of a run."""
    quality = {"steps": rock_scene.QUALITY_STEPS.boundaries.tolist(), "colours": [to_hex(c) for c in rock_scene.QUALITY.colors]}
    return {"ramp": [to_hex(c) for c in rock_scene.DEPTH(range(256))], "quality": quality, "kinds": page3d_parts.COLOURS, "words": page3d_parts.WORDS, "other": bit_scene.OTHER,
            "cones": bit_scene.CONES, "uncut": page3d_scene.UNCUT_COLOUR}


def still():
    """The picture of a bottom hole, small, as an address that holds it."""
    image = Image.open(ROOT / "reports/bottom_hole.png").convert("RGB")
    image.thumbnail((STILL, STILL))
    file = io.BytesIO()
    image.quantize(64).save(file, "PNG", optimize=True)
    return "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()


def in_element(text):
    """A text that no HTML reader takes for the end of its script element. Raises ValueError."""
    if "</script" in text.lower() or "<!--" in text:
        raise ValueError("found </script or <!-- in a script, which would end it")
    return Markup(text)


def read(*names):
    return "\n".join((HERE.parent / name).read_text(encoding="utf-8") for name in names)


def commit():
    found = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty", "--abbrev=12"], capture_output=True, text=True, check=False)
    return found.stdout.strip() or "unknown commit"


def html_of(folder):
    bits = {name: (ROOT / "cases/bits" / name).read_text(encoding="utf-8") for name in BITS}
    constants = json.dumps({"looks": looks(), "bits": bits}, separators=(",", ":")).replace("<", "\\u003c")
    program = base64.b64encode(zlib.compress((folder / "tdbd.wasm").read_bytes(), 9)).decode()
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "page"), autoescape=True, trim_blocks=True,
                                     undefined=jinja2.StrictUndefined, lstrip_blocks=True)
    scripts = [f"reports/web/{name}" for name in SHARED] + [f"web/page/{name}" for name in OWN]
    return environment.get_template("tdbd.html.j2").render(
        style=Markup(read("reports/web/page3d.css", "web/page/tdbd.css")), script=in_element(read(*scripts)), program=in_element(program),
        glue=in_element((folder / "tdbd.js").read_text(encoding="utf-8")), worker=in_element(read("web/page/worker.js")), constants=Markup(constants),
        still=still(), commit=commit(), version=version())


def version():
    """Of the project, in CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return text.split("project(TDBD VERSION ", 1)[1].split()[0]


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=Path, help="holds tdbd.js and tdbd.wasm")
    parser.add_argument("-o", "--output", type=Path, required=True)
    chosen = parser.parse_args(arguments)
    try:
        page = html_of(chosen.folder)
    except (OSError, ValueError) as error:
        print(f"make: {error}", file=sys.stderr)
        return 2
    partial = Path(f"{chosen.output}.partial")
    partial.write_text(page, encoding="utf-8")
    partial.rename(chosen.output)
    print(f"make: {chosen.output.stat().st_size / 1e6:.2f} MB; look at {chosen.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
