"""Includes point one way: a module of src includes only modules below it, a sub-folder only sub-folders of its module below it.

No file is included in a circle either."""

import re

import sources

CORE, IO, MESH = {"core"}, {"core", "io"}, {"core", "io", "mesh"}
BIT = MESH | {"rotation", "bit"}
ROCK, FORCES, DYNAMICS = BIT | {"rock"}, BIT | {"forces"}, {"core", "rotation", "string", "dynamics"}
STRING = {"core", "string"}
SIMULATION = ROCK | FORCES | DYNAMICS | STRING | {"simulation"}
CALIBRATION = SIMULATION | {"calibration"}
ALLOWED = {
    "core": CORE, "io": IO, "rotation": {"core", "rotation"}, "mesh": MESH, "bit": BIT, "rock": ROCK,
    "forces": FORCES, "dynamics": DYNAMICS, "string": STRING, "simulation": SIMULATION, "calibration": CALIBRATION,
    "sweep": CALIBRATION | {"sweep"}, "app": CALIBRATION | {"sweep", "app"},
}
# The sub-folders of each module, from the lowest to the highest; "." are the files of the module itself, but for
# those that stand here by name.
SUB_FOLDERS = {
    "core": (".", "units", "units.cpp", "config"),
    "io": (".",),
    "rotation": (".",),
    "mesh": (".", "shape", "search", "check", "files", "repair", "grade"),
    "bit": (".", "cutter", "cone", "profile", "body", "pdc", "wear", "areas", "report", "files"),
    "rock": ("index", ".", "start", "cut", "section", "maintain"),
    "forces": ("rock_material.hpp", "rock", "part", "laws", "."),
    "dynamics": (".", "rotation", "drilling"),
    "string": (".",),
    "simulation": ("case", "start", "step", "result", "rotate", "chain", "study"),
    "calibration": ("record", "case", "cuts", "fit", "predict", "result", "laboratory"),
    "sweep": ("design", "point", "table", ".", "curve"),
    "app": (".",),
}
# A slow twin may use plain data of src, never the function it is the twin of.
PLAIN_DATA = re.compile(r"(core|io)/.+|mesh/triangle_mesh\.hpp|bit/bit\.hpp|forces/part/part_cut\.hpp|"
                        r"dynamics/(gyrostat|loads|schedule|drilling/drilling_system)\.hpp|reference/.+")
# A program around the twins reads its input and describes it by src's means.
TOOL_DATA = re.compile(PLAIN_DATA.pattern + r"|mesh/(files/files|measures)\.hpp|simulation/rotate/rotate_case\.hpp")
# The comparison runs the models of chapter 2 beside the program itself.
COMPARE_DATA = re.compile(PLAIN_DATA.pattern + r"|(core|io|bit|forces|simulation)/.+")
# A method that does not pay, measured beside the search that is used, whose strips it shares. It is no twin.
WALK_DATA = re.compile(PLAIN_DATA.pattern + r"|mesh/search/.+|rock/cut/swept_mesh\.hpp")
# The Python module stands where the command line does: above all modules, beside app.
PYTHON_DATA = re.compile(rf"({'|'.join(sorted(CALIBRATION | {'sweep'}))})/.+|python/src/.+")
CGAL_ALLOWED = re.compile(
    r"src/mesh/(repair/repair_cgal|check/self_intersections)\.cpp|benchmarks/corefinement\.cpp|reference/.+|verification/.+")
BOOST_ALLOWED = "reference/literature/surface/planar_boolean.cpp"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def sub_folder(path):
    """Of a path below src: "cut" of rock/cut/prism.hpp, "." of rock/rock.hpp."""
    module, *rest = path.split("/")
    return rest[0] if len(rest) > 1 or rest[0] in SUB_FOLDERS[module] else "."


def check_sub_folder(path, target):
    """Why a file of src may not include that header of its own module, or None. Paths below src."""
    module = path.split("/")[0]
    known, own, other = SUB_FOLDERS[module], sub_folder(path), sub_folder(target)
    for sub in (own, other):
        if sub not in known:
            return f"the sub-folder {sub} of src/{module} has no place in include_rules.py"
    if known.index(other) > known.index(own):
        return f"src/{module}/{own} may not include src/{module}/{other}, which is above it"
    return None


def check_include(path, bracket, target):
    """Why this file may not include that one, or None."""
    parts = path.split("/")
    if target.startswith("CGAL/") and not CGAL_ALLOWED.fullmatch(path):
        return ("CGAL belongs in src/mesh/repair/repair_cgal, check/self_intersections, reference/, verification/ "
                "and benchmarks/corefinement.cpp")
    if target.startswith("boost/") and path != BOOST_ALLOWED:
        return f"Boost belongs in {BOOST_ALLOWED}"
    if bracket == "<":
        return None
    allowed = next((data for folder, data in (("reference/tools/", TOOL_DATA), ("reference/compare/", COMPARE_DATA),
                                              ("reference/rock/facet_walk", WALK_DATA))
                    if path.startswith(folder)), PLAIN_DATA)
    if parts[0] == "reference" and not allowed.fullmatch(target):
        return f'a slow twin may not use "{target}"'
    if parts[0] == "python" and not PYTHON_DATA.fullmatch(target):
        return f'the Python module may not use "{target}"'
    if parts[0] == "src":
        if len(parts) < 3 or parts[1] not in ALLOWED:
            return f"the folder of {path} has no line in include_rules.py"
        if target.split("/")[0] not in ALLOWED[parts[1]]:
            return f'src/{parts[1]} may not include "{target}"'
        if target.split("/")[0] == parts[1]:
            return check_sub_folder(path.removeprefix("src/"), target)
    return None


def check_text(path, text):
    problems = []
    code = sources.without_comments(text, keep_strings=True)
    for number, line in enumerate(code.split("\n"), 1):
        if found := INCLUDE.match(line):
            if why := check_include(path, *found.groups()):
                problems.append(f"{path}:{number}: {why}")
    return problems


def circles(includes):
    """Circles of headers, each as a list of paths; includes: {path: paths that it includes}."""
    found, state = [], {}

    def visit(path, trail):
        state[path] = "open"
        for target in sorted(includes.get(path, ())):
            if state.get(target) == "open":
                found.append(trail[trail.index(target):] + [target])
            elif target not in state:
                visit(target, trail + [target])
        state[path] = "done"

    for path in sorted(includes):
        if path not in state:
            visit(path, [path])
    return found


def included(text):
    code = sources.without_comments(text, keep_strings=True)
    return {m[2] for line in code.split("\n") if (m := INCLUDE.match(line)) and m[1] == '"'}


def check_all():
    texts = {f: sources.read(f) for f in sources.tracked("src", "reference", "verification", "benchmarks", "python")}
    problems = [p for f, text in texts.items() for p in check_text(f, text)]
    headers = {f.removeprefix("src/"): included(text) for f, text in texts.items() if f.endswith(".hpp")}
    return problems + ["included in a circle: " + ", ".join(c) for c in circles(headers)]


def self_test():
    good = [("src/rock/cut.cpp", '#include "bit/bit.hpp"'),
            ("src/core/config/csv.cpp", "#include <vector>"),
            ("src/mesh/repair/repair_cgal.cpp", "#include <CGAL/Surface_mesh.h>"),
            ("src/core/config/csv.cpp", '// #include "mesh/measures.hpp"'),
            ("reference/tools/show.cpp", '#include "mesh/files/files.hpp"'),
            ("reference/tools/show.cpp", '#include "simulation/rotate/rotate_case.hpp"'),
            ("reference/rock/cut.cpp", '#include "mesh/triangle_mesh.hpp"'),
            ("reference/compare/ours.cpp", '#include "simulation/step/simulation.hpp"'),
            ("reference/literature/surface/planar_boolean.cpp", "#include <boost/polygon/polygon.hpp>"),
            ("python/src/runs.cpp", '#include "simulation/result/run.hpp"'),
            ("python/src/runs.cpp", '#include "python/src/options.hpp"'),
            ("python/src/sweeps.cpp", '#include "sweep/sweep.hpp"'),
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
           ("reference/rock/cut.cpp", '#include "rock/cut.hpp"'),
           ("reference/tools/show.cpp", '#include "rock/cut.hpp"'),
           ("reference/mesh/measures.cpp", '#include "mesh/measures.hpp"'),
           ("python/src/runs.cpp", '#include "app/arguments.hpp"'),
           ("python/src/runs.cpp", '#include "reference/bit/heel_drag.hpp"'),
           ("src/app/run_commands.cpp", '#include "python/src/options.hpp"'),
           ("reference/dynamics/top.cpp", '#include "dynamics/momenta.hpp"')]
    good += [("src/rock/cut/cut_rock.cpp", '#include "rock/rock.hpp"'), ("src/rock/rock.hpp", '#include "rock/index/near_list.hpp"'),
             ("src/simulation/study/convergence.cpp", '#include "simulation/case/case.hpp"'),
             ("src/forces/law.hpp", '#include "forces/laws/laws.hpp"'),
             ("src/forces/rock/rock_material.cpp", '#include "forces/rock/rock_material.hpp"')]
    bad += [("src/rock/index/near_list.cpp", '#include "rock/rock.hpp"'),
            ("src/rock/rock.hpp", '#include "rock/cut/cut_rock.hpp"'),
            ("src/simulation/case/case.cpp", '#include "simulation/step/simulation.hpp"'),
            ("src/rock/new_sub/a.cpp", '#include "rock/rock.hpp"')]
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a", "c"}}) == [["b", "c", "b"]]
    assert not circles({"a": {"b", "c"}, "b": {"c"}, "d": {"a", "c"}})
    for path, text in good:
        assert not check_text(path, text), (path, text)
    for path, text in bad:
        assert check_text(path, "\n" + text) and ":2:" in check_text(path, "\n" + text)[0], text


if __name__ == "__main__":
    sources.main(check_all, self_test)
