"""TDBD from Python: drill bits cutting rock. Arrays are numpy arrays and always copies. Lengths in m, others in SI.

    c = tdbd.case("cases/bit-b-steady.toml", rock__edge_length="2 mm")
    r = tdbd.run(c)
    r.summary["removed_volume_m3"], r.history, r.rock.vertices, r.plot()
    sim = tdbd.Simulation(c)
    sim.step(100)

Modules: `tdbd.bit` (bit files), `tdbd.mesh` (mesh files), `tdbd.sweep` (designs of many cases).
"""

import os as _os
from pathlib import Path as _Path

# A wheel contains the database of UDUNITS-2, which is read where the system has none.
_units = _Path(__file__).parent / "udunits/udunits2.xml"
if _units.is_file():
    _os.environ.setdefault("UDUNITS2_XML_PATH", str(_units))

from tdbd import _core, bit, mesh, sweep
from tdbd.calibrations import CalibrationResult, calibrate, laboratory
from tdbd.cases import Case, case
from tdbd.errors import CaseError, CaseWarning, FolderError, Mistake, RunError
from tdbd.live import Rotation, Simulation
from tdbd.results import Result, RotationResult, RunResult, load
from tdbd.runs import resume, rotate, run
from tdbd.studies import Convergence, check, converge
from tdbd.surfaces import Surface

#: Lock for `with` around your calls of NetCDF or HDF5 while another thread drills: they are not thread-safe.
FilesLock = _core.FilesLock

#: Version, commit, compiler and flags, as in every summary.
provenance: dict[str, str] = _core.provenance
__version__: str = provenance["version"]

__all__ = [
    "CalibrationResult", "Case", "CaseError", "CaseWarning", "Convergence", "FilesLock", "FolderError", "Mistake",
    "Result", "Rotation", "RotationResult", "RunError", "RunResult", "Simulation", "Surface", "bit", "calibrate",
    "case", "check", "converge", "laboratory", "load", "mesh", "provenance", "resume", "rotate", "run", "sweep",
]
