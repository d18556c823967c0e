"""The modules of src, and the test programs that may detect a fault in each."""

import difflib
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SRC = ROOT / "src"

# The programs of a module, and those of other modules that run after them, in this order. Of the programs with the label
# evidence only those of dynamics are listed, because it has no other tests.
PROGRAMS = {
    "core": (["verify_core"], ["verify_rotation", "verify_mesh", "verify_forces", "verify_bit", "verify_calibration", "verify_simulation",
                               "verify_app"]),
    "io": (["verify_io"], ["verify_simulation", "verify_calibration", "verify_sweep", "verify_app"]),
    "rotation": (["verify_rotation"], ["verify_dynamics", "verify_bit", "verify_drilling", "verify_rock", "verify_simulation"]),
    "mesh": (["verify_mesh"], ["verify_bit", "verify_rock", "verify_simulation"]),
    "bit": (["verify_bit"], ["verify_rock", "verify_simulation"]),
    "rock": (["verify_rock"], ["verify_simulation"]),
    "forces": (["verify_forces"], ["verify_calibration", "verify_simulation"]),
    "dynamics": (["verify_dynamics", "verify_drilling"], ["verify_simulation"]),
    "string": (["verify_string"], []),
    "simulation": (["verify_simulation"], ["verify_calibration", "verify_app"]),
    "calibration": (["verify_calibration", "verify_calibrate"], []),
    "sweep": (["verify_sweep"], []),
    "app": (["verify_app", "verify_calibrate"], []),
}
# Programs that run tdbd, which is then linked with the mutant as well.
CALL_TDBD = {"verify_app", "verify_calibrate"}


def module_problem(name):
    """A message if this is no module, with the nearest name; else empty."""
    if name in PROGRAMS:
        return ""
    nearest = difflib.get_close_matches(name, PROGRAMS, n=1, cutoff=0.0)
    return f"found module \"{name}\", expected one of {', '.join(PROGRAMS)}; the nearest is \"{nearest[0]}\""


def unknown_modules():
    """The modules of src that have no entry in PROGRAMS."""
    return sorted({folder.name for folder in SRC.iterdir() if folder.is_dir() and any(folder.rglob("*.cpp"))} - set(PROGRAMS))


def sources(module):
    return sorted(str(f.relative_to(ROOT)) for f in (SRC / module).rglob("*.cpp"))


def programs_of(module, home_only=False):
    """(programs of the module, programs of others); with home_only the second list is empty."""
    homes, others = PROGRAMS[module]
    return homes, [] if home_only else others


def targets(modules, home_only=False):
    """The build targets for these modules."""
    wanted = {p for module in modules for programs in programs_of(module, home_only) for p in programs}
    return sorted(wanted) + (["tdbd"] if wanted & CALL_TDBD or "sweep" in modules else [])  # sweep is tested by a script


def test_folders(programs):
    """The folders of verification with the sources of these programs."""
    homes = {"verify_drilling": "dynamics", "verify_calibrate": "calibration"}
    scripts = {"sweep/app"} if "verify_app" in programs else set()
    return sorted({homes.get(n, n.removeprefix("verify_")) for n in programs} | {"battery"} | scripts)
