"""The frames of a run as a page shows them: rock, and a bit that moves as rigid bodies. SI units."""

from dataclasses import dataclass
from xml.etree import ElementTree

import numpy as np

from figures import rock_data

RIGID = 1e-6  # m: a body that moves as one leaves no point farther away; files have 16 digits


@dataclass
class Frame:
    number: int  # in the run, from 1
    time: float  # s
    rock: rock_data.Mesh
    poses: list  # of each body: (3, 4), from where it is in the first frame


@dataclass
class Frames:
    listed: int  # by the run
    found: list
    missing: list  # {"number", "time_s", "why"}
    bit: rock_data.Mesh  # where it is in the first frame that was found
    bodies: np.ndarray  # of each point of the bit: 0, or 1 + its cone


def few(items, most):
    """At most so many, evenly spread, the last among them and, of several, the first."""
    if len(items) <= most:
        return items
    return [items[round(k)] for k in np.linspace(len(items) - 1, 0, most)][::-1]


def read_mesh(path, *wanted):
    """A mesh with the values that are wanted. Raises ValueError, whatever is wrong with the file."""
    try:
        mesh = rock_data.read(path)
    except (ElementTree.ParseError, LookupError, TypeError, AttributeError) as error:
        raise ValueError(f"{path}: found no whole frame ({error}), expected one that `tdbd run` writes") from error
    except ValueError as error:
        raise ValueError(str(error) if str(path) in str(error) else f"{path}: found no whole frame ({error})") from error
    if not 0 <= mesh.triangles.min() <= mesh.triangles.max() < len(mesh.points):
        raise ValueError(f"{path}: found triangles of points that it does not have")
    if not np.isfinite(mesh.points).all():
        raise ValueError(f"{path}: found a point that is nowhere, expected finite numbers")
    if lacks := set(wanted) - set(mesh.point_values) - set(mesh.cell_values):
        raise ValueError(f"{path}: found no {', '.join(sorted(lacks))}, expected a frame that `tdbd run` writes")
    return mesh


def bodies_of(bit):
    """Of each point: 0 for the bit itself, 1 + k for its cone k."""
    bodies = np.zeros(len(bit.points), int)
    if "cone" in bit.cell_values:
        bodies[bit.triangles.ravel()] = 1 + np.repeat(bit.cell_values["cone"].astype(int), 3)
    return bodies


def rigid(start, now):
    """(3, 4): the motion that takes points to where they are now (Kabsch 1976). Raises ValueError when none does."""
    middles = start.mean(axis=0), now.mean(axis=0)
    u, _, v = np.linalg.svd((start - middles[0]).T @ (now - middles[1]))
    turn = v.T @ np.diag([1, 1, np.sign(np.linalg.det(v.T @ u.T))]) @ u.T
    shift = middles[1] - turn @ middles[0]
    left = np.abs(start @ turn.T + shift - now).max()
    if not left < RIGID:
        raise ValueError(f"found a bit that changed its shape by {left:.1e} m, expected one that moves as a whole")
    return np.column_stack([turn, shift])


def poses(bit, bodies, now):
    if len(now.points) != len(bit.points):
        raise ValueError(f"found a bit of {len(now.points)} points, expected the {len(bit.points)} of the first frame")
    return [rigid(bit.points[bodies == k], now.points[bodies == k]) for k in range(bodies.max() + 1)]


def read(folder, most):
    """Raises ValueError when the folder has no frame that can be read."""
    rocks, bits = rock_data.frames(folder), rock_data.frames(folder, "bit")
    listed = [(k + 1, *rock, bit[1]) for k, (rock, bit) in enumerate(zip(rocks, bits))]
    frames = Frames(len(listed), [], [], None, None)
    for number, time, rock_file, bit_file in few(listed, most):
        try:
            rock, bit = read_mesh(rock_file, "depth_m", "last_part"), read_mesh(bit_file, "kind", "part")
            if frames.bit is None:
                frames.bit, frames.bodies = bit, bodies_of(bit)
            frames.found.append(Frame(number, time, rock, poses(frames.bit, frames.bodies, bit)))
        except ValueError as error:
            why = str(error).replace(f"{folder}/", "")
            frames.missing.append({"number": number, "time_s": time, "why": why})
    if not frames.found:
        why = frames.missing[0]["why"] if frames.missing else "rock.pvd and bit.pvd list no frame of both"
        raise ValueError(f"{folder}: found no frame to show ({why}), expected those that `tdbd run` writes")
    return frames
