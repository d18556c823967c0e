"""Rooms of src, and the test programs that may notice a fault in each."""

import difflib
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SRC = ROOT / "src"

# A room's own programs, and those of other rooms that are asked after them, in this order. Of the programs with the label
# evidence only those of dynamics are here: its tests are nowhere else.
PROGRAMS = {
    "core": (["verify_core"], ["verify_rotation", "verify_mesh", "verify_forces", "verify_bit", "verify_calibration", "verify_simulation",
                               "verify_app"]),
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
# These call the program tdbd, which is linked with the mutant as well.
CALL_TDBD = {"verify_app", "verify_calibrate"}


def room_problem(name):
    """What is wrong with the name of a room, and which was meant; empty if nothing."""
    if name in PROGRAMS:
        return ""
    nearest = difflib.get_close_matches(name, PROGRAMS, n=1, cutoff=0.0)
    return f"found room \"{name}\", expected one of {', '.join(PROGRAMS)}; the nearest is \"{nearest[0]}\""


def sources(room):
    return sorted(str(f.relative_to(ROOT)) for f in (SRC / room).rglob("*.cpp"))


def programs_of(room, home_only=False):
    """(own programs, those of other rooms); with home_only none of these."""
    homes, others = PROGRAMS[room]
    return homes, [] if home_only else others


def targets(rooms, home_only=False):
    """What must be built for the rooms."""
    wanted = {p for room in rooms for programs in programs_of(room, home_only) for p in programs}
    return sorted(wanted) + (["tdbd"] if wanted & CALL_TDBD or "sweep" in rooms else [])  # which has a script


def test_folders(programs):
    """Where the sources of test programs are."""
    homes = {"verify_drilling": "dynamics", "verify_calibrate": "calibration"}
    scripts = {"sweep/app"} if "verify_app" in programs else set()
    return sorted({homes.get(n, n.removeprefix("verify_")) for n in programs} | {"battery"} | scripts)
