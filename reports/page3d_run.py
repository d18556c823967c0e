"""What a 3-D page shows of a run: its frames, with the rock and a bit that moves as rigid bodies, its summary, its diagnosis, traces of its
history, and its provenance. SI units."""

from dataclasses import dataclass
from xml.etree import ElementTree

import netCDF4
import numpy as np

from figures import bit_motion, rock_data
from figures import results

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


def read_frames(folder, most):
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


MOST = 400  # pieces of a trace; each keeps its least and greatest value, so that no peak is lost
TRACES = {  # in history.nc: what the page calls it, its unit there, the factor to that unit
    "weight_on_bit": ("Weight on bit", "kN", 1e-3),
    "torque_on_bit": ("Torque on bit", "kN m", 1e-3),
    "rate_of_penetration": ("Rate of penetration", "m/h", 3600.0),
    "rotary_speed": ("Speed of the bit", "rpm", 30.0 / np.pi),
}
PROVENANCE = ("version", "commit", "compiler", "flags", "case_hash", "seed", "command")
GIVEN = "none, since the motion of this run is given"
NO_FORCES = ", and it has no force law, so no weight and no torque"


def short(values, digits=4):
    return [float(f"{v:.{digits}g}") for v in values]


def trace(name, unit, time, values):
    """Time in pieces, with the least and the greatest value of each."""
    edges = np.unique(np.linspace(0, len(time), min(len(time), MOST) + 1).astype(int))
    starts = edges[:-1]
    return {"name": name, "unit": unit, "time": short(time[starts], 6), "low": short(np.minimum.reduceat(values, starts)),
            "high": short(np.maximum.reduceat(values, starts))}


def history(folder):
    """{name: values} of the traces, the place and the volume in history.nc; {} without that file. Raises ValueError."""
    wanted = ("time", "position_z", "removed_volume_total", *TRACES)
    if not (folder / "history.nc").is_file():
        return {}
    try:
        with netCDF4.Dataset(folder / "history.nc") as data:
            return {name: np.asarray(data[name][:]) for name in wanted if name in data.variables}
    except (OSError, RuntimeError) as error:
        raise ValueError(f"{folder}/history.nc: found {error}, expected the history that `tdbd run` writes") from error


def traces(folder):
    """Of a run whose motion is given: its rate from its place, and the volume."""
    data = history(folder)
    if len(data.get("time", ())) < 2:
        return []
    drawn = [trace(label, unit, data["time"], factor * data[name]) for name, (label, unit, factor) in TRACES.items() if name in data]
    if "rate_of_penetration" not in data:
        rate = np.gradient(data["position_z"], data["time"])
        drawn.append(trace("Rate of penetration", "m/h", data["time"], 3600.0 * rate))
    if "weight_on_bit" not in data:
        drawn.append(trace("Rock removed", "cm\u00b3", data["time"], 1e6 * data["removed_volume_total"]))
    return drawn


def why_no_traces(folder, drawn):
    """Why the page has no traces; empty if it has some."""
    if drawn:
        return ""
    if not (folder / "history.nc").is_file():
        return "This folder has no history.nc, so there are no traces. tdbd run writes that file; copy it beside summary.json."
    return "history.nc has fewer than two rows, so there are no traces."


def means_words(run):
    """The part of the run over which means are taken."""
    if run.get("means_to_s") is None:
        return "The run is too short for means: output.means_from sets when they begin." if "wob_mean_n" in run else ""
    more = " The imbalance is the mean lateral force in the frame of the bit." if run.get("imbalance") is not None else ""
    return f"Means from {run['means_from_s']:.4g} s to {run['means_to_s']:.4g} s.{more}"


def diagnosis(run):
    if "diagnosis" in run:
        return run["diagnosis"]["text"] + "."
    return GIVEN + ("" if "wob_mean_n" in run else NO_FORCES) + "."


def facts(run):
    """[(what, value)] in the units of the trade."""
    rows = [("status", run["status"]), ("steps", f"{run['steps']}"), ("revolutions", f"{run['revolutions']:.4g}"),
            ("time", f"{run['duration_s']:.4g} s"), ("rock removed", f"{1e6 * run['removed_volume_m3']:.4f} cm\u00b3"),
            ("ledger of volumes, defect", f"{run['volume_ledger_defect']:.1e}"),
            ("triangles of the rock", f"{run['rock_triangles_start']} at the start, {run['rock_triangles_end']} at the end"),
            ("their quality", f"worst {run['rock_quality_min']:.3f}, 1 % below {run['rock_quality_1_percent']:.3f}")]
    means = (("wob_mean_n", "mean weight on bit", 1e-3, "kN"), ("tob_mean_n_m", "mean torque on bit", 1e-3, "kN m"),
             ("rop_mean_m_per_s", "mean rate of penetration", 3600.0, "m/h"))
    means += (("mechanical_specific_energy_pa", "mechanical specific energy (MSE)", 1e-6, "MPa"),
              ("imbalance", "imbalance", 100.0, "% of the weight"))
    shown = [(what, f"{scale * run[key]:.4g} {unit}") for key, what, scale, unit in means if run.get(key) is not None]
    return rows[:1] + shown + rows[1:]


def provenance(run):
    return [(key.replace("_", " "), str(run[key])) for key in PROVENANCE if key in run]


def summary(folder):
    """summary.json of a drilling run. Raises ValueError."""
    try:
        run = results.summary(folder)
        if run.get("command") != "run":
            raise ValueError(f"a result of `tdbd {run.get('command')}`")
        facts(run)
    except OSError as error:
        raise ValueError(f"{folder}: found no summary.json, expected the result folder of `tdbd run`") from error
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{folder}/summary.json: found {error!r}, expected what `tdbd run` writes") from error
    return run
