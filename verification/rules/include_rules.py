"""Includes point one way: between the rooms of src, and between the folders of each room."""

import re

import sources

CORE, MESH = {"core"}, {"core", "mesh"}
BIT, FORCES = MESH | {"rotation", "bit"}, MESH | {"bit", "forces"}
ROCK, DYNAMICS = BIT | {"rock"}, {"core", "rotation", "dynamics"}
SIMULATION = ROCK | FORCES | DYNAMICS | {"simulation"}
CALIBRATION = SIMULATION | {"calibration"}
ALLOWED = {
    "core": CORE, "rotation": {"core", "rotation"}, "mesh": MESH, "bit": BIT, "rock": ROCK,
    "forces": FORCES, "dynamics": DYNAMICS, "simulation": SIMULATION, "calibration": CALIBRATION,
    "app": CALIBRATION | {"app"},
}
# The folders of a room in order: each includes itself and those before it. "." is the room's own level.
FOLDERS = {
    "core": [".", "config"],
    "mesh": [".", "search", "shape", "check", "grade", "files", "repair"],
    "bit": [".", "cutter", "cone", "body", "pdc", "profile", "files", "report"],
    "rock": ["index", ".", "cut", "section", "maintain", "start"],
    "forces": ["rock", "part", "laws", "."],
    "dynamics": [".", "rotation", "drilling"],
    "simulation": ["case", "start", "step", "result", "rotate", "study"],
}
# A slow twin may use plain data of src, never the function it is the twin of.
PLAIN_DATA = re.compile(r"core/.+|mesh/triangle_mesh\.hpp|bit/bit\.hpp|"
                        r"dynamics/(drilling/drilling_system|gyrostat|loads|rotation_state|schedule)\.hpp|reference/.+")
# A program around the twins reads its input and describes it by src's means.
TOOL_DATA = re.compile(PLAIN_DATA.pattern + r"|mesh/(files/files|measures)\.hpp|simulation/rotate/rotate_case\.hpp")
CGAL_ALLOWED = re.compile(
    r"src/mesh/(files/files|repair/repair_cgal|check/self_intersections)\.cpp|benchmarks/corefinement\.cpp|reference/.+|"
    r"verification/.+")
BOOST_ALLOWED = "reference/literature/planar_boolean.cpp"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """Room and folder of a file below src: ("bit", "cone"); ("bit", ".") for the room's own level."""
    parts = path.split("/")
    return parts[0], "/".join(parts[1:-1]) or "."


def check_folders(path, target):
    """Why a source of a room may not include that header of the same room, or None."""
    (room, here), (other, there) = folder_of(path), folder_of(target)
    if room != other or here == there:
        return None
    order = FOLDERS.get(room, [])
    for folder in (here, there):
        if folder not in order:
            return f"the folder {room}/{folder} has no place in FOLDERS of include_rules.py"
    if order.index(there) > order.index(here):
        return f'src/{room}/{here} may not include "{target}": {there} comes after it'
    return None


def check_include(path, bracket, target):
    """Why this file may not include that one, or None."""
    parts = path.split("/")
    if target.startswith("CGAL/") and not CGAL_ALLOWED.fullmatch(path):
        return ("CGAL belongs in src/mesh/files/files, repair_cgal, self_intersections, reference/, verification/ and "
                "benchmarks/corefinement.cpp")
    if target.startswith("boost/") and path != BOOST_ALLOWED:
        return f"Boost belongs in {BOOST_ALLOWED}"
    if bracket == "<":
        return None
    allowed = TOOL_DATA if path.startswith("reference/tools/") else PLAIN_DATA
    if parts[0] == "reference" and not allowed.fullmatch(target):
        return f'a slow twin may not use "{target}"'
    if parts[0] == "src":
        if len(parts) < 3 or parts[1] not in ALLOWED:
            return f"the folder of {path} has no line in include_rules.py"
        if target.split("/")[0] not in ALLOWED[parts[1]]:
            return f'src/{parts[1]} may not include "{target}"'
        return check_folders(path.removeprefix("src/"), target)
    return None


def check_text(path, text):
    problems = []
    code = sources.without_comments(text, keep_strings=True)
    for number, line in enumerate(code.split("\n"), 1):
        if found := INCLUDE.match(line):
            if why := check_include(path, *found.groups()):
                problems.append(f"{path}:{number}: {why}")
    return problems


def check_all():
    files = sources.tracked("src", "reference", "verification", "benchmarks")
    return [p for f in files for p in check_text(f, sources.read(f))]


def self_test():
    good = [("src/rock/cut.cpp", '#include "bit/bit.hpp"'),
            ("src/core/config/csv.cpp", "#include <vector>"),
            ("src/mesh/files/files.cpp", "#include <CGAL/Surface_mesh.h>"),
            ("src/core/config/csv.cpp", '// #include "mesh/measures.hpp"'),
            ("reference/tools/show.cpp", '#include "mesh/files/files.hpp"'),
            ("reference/tools/show.cpp", '#include "simulation/rotate/rotate_case.hpp"'),
            ("reference/rock/cut.cpp", '#include "mesh/triangle_mesh.hpp"'),
            ("reference/literature/planar_boolean.cpp", "#include <boost/polygon/polygon.hpp>"),
            ("src/bit/files/bit_file.cpp", '#include "bit/cone/cone_bit.hpp"'),
            ("src/rock/rock.hpp", '#include "rock/index/vertex_grid.hpp"'),
            ("src/rock/cut/cut_rock.hpp", '#include "rock/rock.hpp"'),
            ("src/simulation/step/simulation.cpp", '#include "bit/files/bit_file.hpp"'),
            ("reference/dynamics/top.cpp", '#include "dynamics/loads.hpp"')]
    bad = [("src/core/config/csv.cpp", '#include "mesh/measures.hpp"'),
           ("src/mesh/files/files.cpp", '#include "bit/bit.hpp"'),
           ("src/rotation/so3.cpp", '#include "mesh/measures.hpp"'),
           ("src/rock/cut.cpp", '#  include "reference/rock/cut.hpp"'),
           ("src/rock/cut.cpp", '#include "verification/rock/scene.hpp"'),
           ("src/forces/law.cpp", '#include "rock/cut.hpp"'),
           ("src/rock/cut.cpp", "#include <CGAL/Surface_mesh.h>"),
           ("benchmarks/step.cpp", "#include <CGAL/Surface_mesh.h>"),
           ("reference/rock/cut.cpp", "#include <boost/polygon/polygon.hpp>"),
           ("src/new_folder/a.cpp", '#include "core/types.hpp"'),
           ("src/bit/cone/cone_bit.cpp", '#include "bit/files/bit_file.hpp"'),
           ("src/rock/index/vertex_grid.cpp", '#include "rock/rock.hpp"'),
           ("src/simulation/case/case.hpp", '#include "simulation/step/simulation.hpp"'),
           ("src/bit/cone/cone_bit.cpp", '#include "bit/new_folder/a.hpp"'),
           ("src/bit/new_folder/a.cpp", '#include "bit/bit.hpp"'),
           ("reference/rock/cut.cpp", '#include "rock/cut.hpp"'),
           ("reference/tools/show.cpp", '#include "rock/cut.hpp"'),
           ("reference/mesh/measures.cpp", '#include "mesh/measures.hpp"'),
           ("reference/dynamics/top.cpp", '#include "dynamics/momenta.hpp"')]
    for path, text in good:
        assert not check_text(path, text), (path, text)
    for path, text in bad:
        assert check_text(path, "\n" + text) and ":2:" in check_text(path, "\n" + text)[0], text


if __name__ == "__main__":
    sources.main(check_all, self_test)
