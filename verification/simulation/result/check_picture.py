"""check_picture.py PNG MIN_WIDTH MIN_HEIGHT MIN_COLOURS: fails when a picture is small or blank."""

import sys

import matplotlib.image
import numpy as np

path, width, height, colours = sys.argv[1], *map(int, sys.argv[2:5])
pixels = (255 * matplotlib.image.imread(path)[:, :, :3]).astype(np.uint32)
packed = pixels[:, :, 0] << 16 | pixels[:, :, 1] << 8 | pixels[:, :, 2]
found = len(np.unique(packed))
print(f"{path}: {pixels.shape[1]} x {pixels.shape[0]} pixels, {found} colours")
if pixels.shape[1] < width or pixels.shape[0] < height or found < colours:
    sys.exit(f"{path}: expected at least {width} x {height} pixels and {colours} colours")
