"""single_tooth.py OUT.off: a tooth for cases/single-tooth.toml, the ball of a hemispherical insert of 12 mm.

Rings about the vertical axis, close together below, where the tooth meets rock; vertices on the ball, in mm,
the lowest at (0, 0, 0), z down.
"""

import math
import pathlib
import sys

RADIUS, AROUND = 6.0, 48
ANGLES = [*range(4, 64, 4), *range(75, 180, 15)]  # degrees from the lowest point


def corners():
    yield 0.0, 0.0, 0.0
    for angle in map(math.radians, ANGLES):
        for turn in (2 * math.pi * i / AROUND for i in range(AROUND)):
            across = RADIUS * math.sin(angle)
            yield across * math.cos(turn), across * math.sin(turn), RADIUS * (math.cos(angle) - 1)
    yield 0.0, 0.0, -2 * RADIUS


def triangles():
    """Outward, where z points down."""
    vertex = lambda ring, i: 1 + ring * AROUND + i % AROUND
    last = len(ANGLES) - 1
    for i in range(AROUND):
        yield 0, vertex(0, i), vertex(0, i + 1)
        yield 1 + len(ANGLES) * AROUND, vertex(last, i + 1), vertex(last, i)
        for ring in range(last):
            a, b, c, d = vertex(ring, i), vertex(ring, i + 1), vertex(ring + 1, i), vertex(ring + 1, i + 1)
            yield a, c, b
            yield b, c, d


def main(out):
    points, faces = list(corners()), list(triangles())
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(f"{v + 0.0:.6f}" for v in p) for p in points]
    lines += [f"3 {a} {b} {c}" for a, b, c in faces]
    pathlib.Path(out).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
