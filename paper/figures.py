#!/usr/bin/python3
"""Makes the two figures of the paper from the program's results.

    build/release/tdbd run cases/bit-b-steady.toml -o results/paper     # some seconds
    /usr/bin/python3 paper/figures.py results/paper                     # paper/hole.png and paper/volume.png

hole.png is the picture of `tdbd draw`. volume.png is the figure of the study steady-bit-b, which `scripts/report --study
steady-bit-b` draws from the data in that study. Both are reduced to 1200 pixels and 256 colours, so that they stay below
200 kB. --program names another tdbd.
"""

import argparse
import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
WIDTH, COLOURS, LARGEST = 1200, 256, 200_000


def reduce(source, target):
    with Image.open(source) as picture:
        picture = picture.convert("RGB")
        if picture.width > WIDTH:
            picture = picture.resize((WIDTH, round(picture.height * WIDTH / picture.width)), Image.LANCZOS)
        picture.quantize(COLOURS, dither=Image.Dither.NONE).save(target, optimize=True)
    size = target.stat().st_size
    print(f"{target.relative_to(ROOT)}: {size / 1000:.0f} kB")
    return size <= LARGEST


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("result", type=Path, help="result folder of cases/bit-b-steady.toml")
    parser.add_argument("--program", default=str(ROOT / "build/release/tdbd"))
    arguments = parser.parse_args()
    subprocess.run([arguments.program, "draw", arguments.result], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["bash", "scripts/report", "--study", "steady-bit-b"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    small = [reduce(arguments.result / "bottom_hole.png", ROOT / "paper/hole.png"),
             reduce(ROOT / "results/report/studies/steady-bit-b/figure.png", ROOT / "paper/volume.png")]
    if not all(small):
        sys.exit(f"figures: a figure is larger than {LARGEST / 1000:.0f} kB")


if __name__ == "__main__":
    main()
