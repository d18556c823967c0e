"""The frames of a run as a page shows them: rock, and a bit that moves as rigid bodies. SI units."""

from dataclasses import dataclass
from xml.etree import ElementTree

import numpy as np

from figures import bit_motion, rock_data


@dataclass
class Frame:
    number: int  # in the run, from 1
    time: float  # s
    rock: rock_data.Mesh
    poses: np.ndarray  # (bodies, 3, 4): from where each is at rest


@dataclass
class Frames:
    listed: int  # by the run
    found: list
    missing: list  # {"number", "time_s", "why"}
    bit: rock_data.Mesh  # at rest
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


def read(folder, most):
    """Raises ValueError when the folder has no frame that can be read."""
    rocks, poses = rock_data.frames(folder), bit_motion.poses(folder)
    if len(rocks) != len(poses):
        raise ValueError(f"{folder}: found {len(rocks)} frames of the rock and {len(poses)} of the bit, expected as many")
    bit = read_mesh(folder / "frames/bit_final.vtp", "kind", "part")
    frames = Frames(len(rocks), [], [], *bit_motion.at_rest(bit, poses[-1][1]))
    listed = [(k + 1, *rock, pose[1]) for k, (rock, pose) in enumerate(zip(rocks, poses))]
    for number, time, rock_file, pose in few(listed, most):
        try:
            frames.found.append(Frame(number, time, read_mesh(rock_file, "depth_m", "last_part"), pose))
        except ValueError as error:
            why = str(error).replace(f"{folder}/", "")
            frames.missing.append({"number": number, "time_s": time, "why": why})
    if not frames.found:
        raise ValueError(f"{folder}: found no frame to show ({frames.missing[0]['why']}), expected those that `tdbd run` writes")
    return frames
