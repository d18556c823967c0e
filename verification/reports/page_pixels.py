"""What tests of pages look at: the pixels of the 3-D picture, and whether the text is readable. Both pages have `view` and `place`."""

import io

import numpy as np
from PIL import Image

READABLE = 4.5  # contrast of text, WCAG 2.1 AA
INK_AND_PAPER = "(c => [c.color, c.backgroundColor].map(x => x.match(/\\d+/g).slice(0, 3).map(Number)))(getComputedStyle(document.body))"


def contrast(ink, paper):
    """Of two colours, as WCAG 2.1 defines it."""
    def light(colour):
        share = np.array(colour) / 255
        return np.dot([0.2126, 0.7152, 0.0722], np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4))
    low, high = sorted((light(ink), light(paper)))
    return (high + 0.05) / (low + 0.05)


def pixels(window, folder=None, name=None):
    """Of the 3-D picture; a folder and a name keep what the whole window shows."""
    image = Image.open(io.BytesIO(window.picture())).convert("RGB")
    if folder and name:
        folder.mkdir(exist_ok=True)
        image.save(folder / f"{name}.png")
    x, y, wide, high = window.value("(r => [r.x, r.y, r.width, r.height])(place('view').getBoundingClientRect())")
    return np.asarray(image.crop([round(x) + 2, round(y) + 2, round(x + wide) - 2, round(y + high) - 2])).astype(int)
