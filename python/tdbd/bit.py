"""Bits: read a bit file, inspect its cutters, mass and imbalance, and export it.

    bit = tdbd.bit.read("cases/bits/bit-b.toml", adjust__back_rake="3 deg")
    bit.facts["mass_kg"], bit.cutters.sel(cutter="cutter-5"), bit.imbalance().planar
    bit.export("out/bit-b", solids="stl")
"""

import functools
import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from tdbd import _core
from tdbd.arguments import assignments
from tdbd.errors import CaseError
from tdbd.surfaces import Surface

if TYPE_CHECKING:
    import xarray

_SPEED = 4 * np.pi  # rad/s, 120 rpm
_UNITS = {"volume": "m3", "density": "kg m-3"}
_UNITS |= dict.fromkeys(("azimuth", "profile_angle", "back_rake", "side_rake", "chamfer_angle", "land_angle"), "rad")
_UNITS |= dict.fromkeys(("diameter", "tip_radius", "tip_height", "chamfer", "land", "length", "table_thickness", "wear",
                         "under_exposure"), "m")


def _dataset(dimension: str, names: list[str], columns: Mapping[str, Any]) -> "xarray.Dataset":
    """Returns columns as a Dataset; the names label the dimension."""
    import xarray

    data = {name: (dimension, np.asarray(values), {"units": _UNITS[name]} if name in _UNITS else {})
            for name, values in columns.items()}
    return xarray.Dataset(data, coords={dimension: np.asarray(names, dtype=object)})


@dataclass(frozen=True)
class Imbalance:
    """Imbalances of a bit before drilling, for comparison of bits; the drilled one is in a run's summary."""

    unit_law: float  #: lateral resultant over the sum of forces, if each cutter pushes along its normal with its area
    unit_law_vector: np.ndarray = field(repr=False)  #: (3,) the same as a vector, bit frame
    planar: float  #: lateral resultant over the weight, planar model with cutting and normal forces
    mean_redundancy: float  #: mean number of cutters that cut at a radius
    areas: np.ndarray = field(repr=False)  #: (cutters,) area that each cutter cuts, m2
    penetration: float = 5e-3  #: m per revolution


class Bit:
    """A bit as read from its file. Returned by `tdbd.bit.read`."""

    def __init__(self, path: str, overrides: list[str]) -> None:
        _core.require_kind(path, overrides, ["bit"])
        self.path = path
        self.overrides = tuple(overrides)
        try:
            self._read = _core.read_bit(path, overrides)
        except CaseError as error:  # overrides are keys of the bit file here, not of a case
            raise CaseError(re.sub(r"^bit\.set\.", "", str(error), flags=re.M)) from None

    def __repr__(self) -> str:
        counts = f"{len(self._columns['id'])} cutters, {len(self._parts['name'])} parts"
        return f"<tdbd.bit.Bit {self.name}: {counts}, gage {2e3 * self.gage_radius:.2f} mm>"

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the path and overrides, so that another process reads the file again."""
        return Bit, (self.path, list(self.overrides))

    @functools.cached_property
    def _columns(self) -> dict[str, Any]:
        return _core.bit_cutters(self._read)

    @functools.cached_property
    def _parts(self) -> dict[str, Any]:
        return _core.bit_parts(self._read)

    @property
    def name(self) -> str:
        """Name of the bit."""
        return self._read.name

    @property
    def gage_radius(self) -> float:
        """Largest radius of a cutting part, m."""
        return self._read.gage_radius

    @property
    def files(self) -> list[str]:
        """The bit file and the files that it names."""
        return list(self._read.files)

    @functools.cached_property
    def cutters(self) -> "xarray.Dataset":
        """The cutter table with units; dimension cutter: `cutters.sel(cutter="cutter-5")`. SI."""
        return _dataset("cutter", [f"cutter-{number}" for number in self._columns["id"]], self._columns)

    @functools.cached_property
    def parts(self) -> "xarray.Dataset":
        """Kind, cutting, triangles, volume and density of all parts: `parts.sel(part="cutter-5/face")`."""
        columns = {name: values for name, values in self._parts.items() if name != "name"}
        return _dataset("part", self._parts["name"], columns)

    @functools.cached_property
    def facts(self) -> dict[str, Any]:
        """Counts, gage, mass, centre of mass and inertia; the mass is None if a part has no density. SI."""
        mass = _core.bit_mass(self._read)
        solid = dict(zip(("mass_kg", "centre_m", "inertia_kg_m2"), mass if mass else (None, None, None)))
        blades = len(np.unique(self._columns["blade"]))
        return {"name": self.name, "cutters": len(self._columns["id"]), "blades": blades, "cones": self._read.cones,
                "parts": len(self._parts["name"]), "gage_diameter_m": 2 * self.gage_radius, **solid,
                "without_density": list(self._read.without_density)}

    def imbalance(self, penetration: float = 5e-3, normal_ratio: float = 0.8) -> Imbalance:
        """Imbalances at an advance per revolution (m).

        `normal_ratio`: normal over cutting force of the planar model.
        """
        if not penetration > 0:
            raise ValueError(f"penetration: found {penetration}, expected a length > 0 in m")
        return Imbalance(**_core.bit_imbalance(self._read, penetration, normal_ratio), penetration=penetration)

    def analysis(self, penetration: float = 5e-3, speed: float = _SPEED,
                 cone_speeds: Sequence[float] = ()) -> dict[str, Any]:
        """analysis.json of `tdbd bit --report`: cutters, parts, overlaps, profile, cones. `speed` in rad/s; SI."""
        return json.loads(_core.bit_analysis(self._read, penetration, speed, list(cone_speeds)))

    @property
    def surface(self) -> Surface:
        """All parts as one surface, in the frame of the bit."""
        vertices, faces, _ = _core.bit_surface(self._read)
        return Surface(vertices, faces)

    @property
    def profile(self) -> tuple[np.ndarray, np.ndarray]:
        """Radii and heights (m) of the envelope of the cutting parts in one half-plane."""
        return _core.bit_profile(self._read)

    def replace(self, set: Mapping[str, Any] | None = None, **keys: Any) -> "Bit":
        """Returns the same file with further overrides, which take precedence over earlier ones."""
        return Bit(self.path, [*self.overrides, *assignments(set, keys)])

    def export(self, folder: str | os.PathLike[str], *, format: str = "ply", solids: str = "stl", unit: str = "mm",
               force: bool = False) -> None:
        """Writes the files of `tdbd bit -o FOLDER`.

        These are bit.toml with parts/, solids.toml with the whole bit, cutters.csv, profile.csv and bit.vtp.

        `format` of the parts and `solids` of the whole bit: "ply", "off", "obj" or "stl". `unit` of STL, OBJ
        and OFF files, which their headers state; PLY is in metres. `force` replaces an older export.
        """
        for name, given in (("format", format), ("solids", solids)):
            if given not in ("ply", "off", "obj", "stl"):
                raise ValueError(f"{name}: found {given!r}, expected 'ply', 'off', 'obj' or 'stl'")
        _core.export_bit(self._read, os.fspath(folder), format, solids, unit, force)


def read(path: str | os.PathLike[str], set: Mapping[str, Any] | None = None, **keys: Any) -> Bit:
    """Reads and checks a bit file, with overrides as for `tdbd.case`. Raises CaseError that lists every mistake."""
    return Bit(os.fsdecode(path), assignments(set, keys))
