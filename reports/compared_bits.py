"""The two sides of a comparison of bits: geometry, forces per cutter and sums, from bit files or from results of `tdbd run`. SI units."""

import math
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import result_kind
from figures import rock_data
from result_kind import NoResult

# Of the estimate for bit files. The stress of the normal force is that of the weight curve of `tdbd bit --report`; the specific energy of
# cutting is taken as the strength of the rock.
NORMAL_OVER_STRENGTH, DRAG_OVER_STRENGTH = 0.8, 1.0


@dataclass
class Side:
    """One bit. Arrays have one entry for each cutter."""

    name: str
    radius: np.ndarray  # m, of the tip
    height: np.ndarray  # m, of the tip over the profile's origin; up
    blades: np.ndarray
    normal: np.ndarray  # N
    drag: np.ndarray  # N
    power: np.ndarray  # W
    area: np.ndarray  # m2; of runs: nan
    sums: dict  # quantity: value
    pushes: dict = field(default_factory=dict)  # name: (x, y) of a lateral force on the bit over the weight
    profile: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))  # r, z in m
    outlines: list = field(default_factory=list)  # (k, 2) of each cutter: r, z in m
    mesh: rock_data.Mesh = None


@dataclass(frozen=True)
class Operation:
    """How the bits of bit files drill."""

    penetration: float  # m per revolution
    speed: float  # rad/s
    strength: float  # Pa


def analysed(bit, folder, program, operation):
    """analysis.json of a bit file, which `tdbd bit --report` writes into a folder. Raises NoResult."""
    words = [str(program), "bit", str(bit), "-o", str(folder), "--report", "--quiet", "--penetration", f"{operation.penetration!r} m"]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode:
        raise NoResult(done.stderr.strip().removeprefix("tdbd: ") or f"{bit}: tdbd bit failed")
    return result_kind.read(folder / "analysis.json")


def estimated_pushes(cutters, normal, drag, weight):
    """Lateral forces on the bit over the weight: of normal forces, of drag, of both."""
    n = np.array([c["profile_normal"][:2] for c in cutters])
    azimuth = np.array([c["azimuth_rad"] for c in cutters])
    pushes = {"the normal forces": -(normal[:, None] * n).sum(axis=0) / weight,
              "the drag": (drag[:, None] * np.column_stack([np.sin(azimuth), -np.cos(azimuth)])).sum(axis=0) / weight}
    return pushes | {"both": pushes["the normal forces"] + pushes["the drag"]}


def of_bit(bit, folder, program, operation):
    """A bit file: forces are cut areas in steady drilling times stresses in proportion to the strength. Raises NoResult."""
    analysis = analysed(bit, folder, program, operation)
    cutters = analysis["cutters"]
    if not cutters:
        raise NoResult(f"{bit}: found a bit without cutters, expected a PDC bit; of roller cone bits compare two results of tdbd run")
    area, radius = (np.array([c[key] for c in cutters], dtype=float) for key in ("area_m2", "tip_radius_m"))
    normal, drag = (share * operation.strength * area for share in (NORMAL_OVER_STRENGTH, DRAG_OVER_STRENGTH))
    weight = float((normal * np.array([c["profile_normal"][2] for c in cutters])).sum())
    if not weight > 0.0:
        raise NoResult(f"{bit}: found cutters that cut no rock at {1e3 * operation.penetration:.4g} mm a revolution, expected some that do")
    pushes = estimated_pushes(cutters, normal, drag, weight)
    rows = (Path(folder) / "profile.csv").read_text(encoding="utf-8").splitlines()[1:]
    side = Side(analysis["name"], radius, np.array([c["tip_height_m"] for c in cutters]), np.array([c["blade"] for c in cutters]), normal, drag,
                drag * radius * operation.speed, area, {}, pushes, np.array([r.split(",") for r in rows], dtype=float),
                [np.array(c["outline_rz_m"]) for c in cutters], rock_data.read(Path(folder) / "bit.vtp"))
    side.sums = {**geometry(analysis), "weight on bit kN": 1e-3 * weight, "torque on bit kN m": 1e-3 * float((drag * radius).sum()),
                 "drilling power kW": 1e-3 * float(side.power.sum() + weight * operation.penetration * operation.speed / (2.0 * math.pi)),
                 **{f"imbalance of {name} % of the weight on bit": 100 * float(np.hypot(*push)) for name, push in pushes.items()}, **spread(side)}
    return side


def geometry(analysis):
    """Numbers of a bit that do not depend on forces."""
    cutters = analysis["cutters"]
    body = analysis.get("body", {})
    sums = {"gage diameter mm": 2e3 * analysis["gage_radius_m"], "mass kg": analysis["mass_kg"], "blades": len({c["blade"] for c in cutters}),
            "cutters": len(cutters), "mean diameter of the cutters mm": 1e3 * float(np.mean([c["diameter_m"] for c in cutters])),
            "mean back rake deg": math.degrees(float(np.mean([c["back_rake_rad"] for c in cutters]))),
            "cutters that cut at each radius, mean": analysis["mean_redundancy"]}
    for key, words, factor in (("junk_slot_area_m2", "junk slots mm²", 1e6), ("touches_at_m_per_rev", "advance at which the body touches the rock mm/rev", 1e3)):
        if body.get(key) is not None:
            sums[words] = factor * body[key]
    return sums


def spread(side):
    """How evenly the cutters that cut share force and work."""
    cuts = side.drag > 0.0
    work = side.power[cuts]
    return {"cutters that cut": int(cuts.sum()), "largest normal force of a cutter kN": 1e-3 * float(side.normal.max(initial=0.0)),
            "largest drag of a cutter kN": 1e-3 * float(side.drag.max(initial=0.0)),
            "largest work rate of a cutter W": float(side.power.max(initial=0.0)),
            "unevenness of work rates (deviation over mean)": float(work.std() / work.mean()) if work.size and work.mean() else math.nan}


def loads_by_cutter(summary):
    """{cutter: (normal N, drag N, power W)} summed over the parts of each cutter, or of each tooth row of a cone bit."""
    found = {}
    for part in summary["forces"]:
        name = re.split(r"/", part["name"])[0]
        found.setdefault(name, np.zeros(3))
        found[name] += [part["normal_mean_n"], part["tangential_mean_n"], part["power_mean_w"]]
    return found


def of_run(folder):
    """A result of `tdbd run` with forces of a bit with cutters. Raises NoResult."""
    result_kind.demand(folder, ("run",))
    summary, bit = result_kind.read(folder / "summary.json"), result_kind.read(folder / "bit.json")
    if not summary.get("forces") or not summary.get("wob_mean_n"):
        raise NoResult(f"{folder}: found a run without forces, expected one whose case has a table [forces]")
    cutters = bit.get("cutters", [])
    if not cutters:
        raise NoResult(f"{folder}: found a bit without cutters, expected a PDC bit")
    loads = loads_by_cutter(summary)
    values = np.array([loads.get(c["name"], np.zeros(3)) for c in cutters])
    side = Side(f"{bit.get('name') or summary['title']} ({folder.resolve().name})", np.array([c["tip_radius_m"] for c in cutters]),
                np.array([c.get("tip_height_m", math.nan) for c in cutters]), np.array([c.get("blade", 0) for c in cutters]), *values.T,
                np.full(len(cutters), math.nan), {})
    angle = summary.get("imbalance_azimuth_rad") or 0.0
    side.pushes = {"of the run": (summary.get("imbalance") or 0.0) * np.array([math.cos(angle), math.sin(angle)])}
    side.sums = {"gage diameter mm": 2e3 * summary["gage_radius_m"], "cutters": len(cutters), **sums_of_run(summary), **spread(side)}
    if (folder / "frames" / "bit_final.vtp").is_file():
        side.mesh = rock_data.final(folder, "bit")
    return side


def sums_of_run(summary):
    named = (("weight on bit kN", "wob_mean_n", 1e-3), ("torque on bit kN m", "tob_mean_n_m", 1e-3),
             ("rate of penetration m/h", "rop_mean_m_per_s", 3600.0), ("rotary speed rpm", "rotary_speed_mean_rad_per_s", 30.0 / math.pi),
             ("mechanical specific energy MPa", "mechanical_specific_energy_pa", 1e-6), ("imbalance % of the weight on bit", "imbalance", 100.0),
             ("drilling power kW", "drilling_power_mean_w", 1e-3))
    return {words: factor * summary[key] for words, key, factor in named if summary.get(key) is not None}
