"""tdbd mesh: inspects, repairs and grades; never touches its input; refuses what it cannot do.
tdbd bit, run and rotate: bad meshes are refused with the command that repairs them, and it does."""

import json
import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile
from random import Random

PROGRAM, BIT = sys.argv[1:3]
CUBE = [(0, 0, 0), (40, 0, 0), (40, 40, 0), (0, 40, 0), (0, 0, 40), (40, 0, 40), (40, 40, 40),
        (0, 40, 40)]
SIDES = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5),
         (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]


def tdbd(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def solid(name, triangles=SIDES, points=CUBE):
    facets = "".join("facet normal 0 0 0\nouter loop\n"
                     + "".join("vertex {} {} {}\n".format(*points[v]) for v in t)
                     + "endloop\nendfacet\n" for t in triangles)
    return f"solid {name}\n{facets}endsolid {name}\n"


def refused(result, *words):
    assert result.returncode == 2, result
    for word in words:
        assert word in result.stderr, (word, result.stderr)


def check_inspection(folder):
    """The numbers of a cube of 40 mm, and of the same file read in inches."""
    (folder / "cube.stl").write_text(solid("cutter-1/face"))
    row = tdbd("mesh", folder / "cube.stl").stdout.splitlines()[1].split()
    assert row[:7] == ["cutter-1/face", "8", "12", "1", "yes", "yes", "yes"], row
    assert row[7] == "64000.000" and row[8:11] == ["40.000"] * 3 and row[-1] == "0", row
    inches = tdbd("mesh", folder / "cube.stl", "--unit", "1 in").stdout.splitlines()[1].split()
    assert inches[8] == "1016.000", inches
    refused(tdbd("mesh", folder / "cube.stl", "--unit", "1 kg"), "--unit: found '1 kg'")
    refused(tdbd("mesh", folder / "none.stl"), "no such file")


def broken_meshes():
    """{message that rejects the mesh: (mesh, report of its repair)}."""
    flipped = [t[::-1] if i in (3, 8) else t for i, t in enumerate(SIDES)]
    far = CUBE + [(x + 20, y + 10, z + 10) for x, y, z in CUBE]
    return {
        "hole: 3 times": (SIDES[:-1], CUBE, "1 holes filled"),
        "flipped triangle: 6 times": (flipped, CUBE, "2 facets flipped"),
        "inside out: enclosed volume": ([t[::-1] for t in SIDES], CUBE, "12 facets flipped"),
        "edge of more than two triangles: 3 times":
            (SIDES + [SIDES[4]], CUBE, "1 duplicate facets dropped"),
        "degenerate triangle: triangle 12":
            (SIDES + [(0, 1, 1)], CUBE, "1 facets without area removed"),
        "self-intersection": (SIDES + [tuple(v + 8 for v in t) for t in SIDES], far,
                              "intersecting pairs of facets removed"),
    }


def check_repairs(folder):
    """Each is refused by tdbd mesh and tdbd bit; the command that they print repairs it."""
    for number, (words, (triangles, points, done)) in enumerate(broken_meshes().items()):
        path = folder / f"bad {number}.stl"
        path.write_text(solid("cutter-1/face", triangles, points))
        before = path.read_bytes()
        (folder / "bit.toml").write_text(f'name = "b"\n[solids]\nfile = "{path.name}"\n')
        for result in (tdbd("mesh", path), tdbd("bit", folder / "bit.toml")):
            refused(result, words, " mm", "solid cutter-1/face", "to repair: tdbd mesh ")
        command = shlex.split(re.search("to repair: tdbd (.*)", result.stderr).group(1))
        repaired = tdbd(*command)
        assert repaired.returncode == 0 and done in repaired.stdout, (words, repaired)
        assert path.read_bytes() == before, "the input was touched"
        assert tdbd("mesh", command[-1]).returncode == 0
        refused(tdbd(*command), "exists; --force replaces it")
        assert tdbd(*command, "--force").returncode == 0


def check_conversions(folder):
    """A file that is only read is written in another format or unit, as it is; an unsound one with its faults."""
    cube = folder / "convert.stl"
    cube.write_text(solid("a"))
    done = tdbd("mesh", cube, "-o", folder / "inches.obj", "--output-unit", "in")
    assert done.returncode == 0 and "in in\n" in done.stdout, done
    back = tdbd("mesh", folder / "inches.obj", "-o", folder / "back.stl", "--output-unit", "mm", "--binary")
    assert back.returncode == 0 and back.stdout.splitlines()[2].split()[7] == "64000.000", back
    refused(tdbd("mesh", cube, "-o", folder / "back.stl"), "exists; --force replaces it")
    cube.write_text(solid("a", SIDES[1:]))
    refused(tdbd("mesh", cube, "-o", folder / "open.ply"), "hole: 3 times")
    assert (folder / "open.ply").exists()


def check_refused_repairs(folder):
    """Nothing is written for a mesh that encloses no solid, and the input is not overwritten."""
    bad = folder / "wall.stl"
    bad.write_text(solid("a", SIDES[1:] + [(1, 3, 4), (1, 6, 4)]))
    refused(tdbd("mesh", bad, "--repair", "-o", folder / "no.stl"), "solid a: cannot be repaired: ")
    refused(tdbd("mesh", bad), "tdbd mesh --repair cannot repair this: ")
    assert not (folder / "no.stl").exists()
    refused(tdbd("mesh", bad, "--repair", "-o", bad, "--force"), "found the input itself")
    refused(tdbd("mesh", bad, "--repair"), "--output: found no file")


def check_field_files(folder):
    """A warning for bytes after a binary STL; a body in a body counts once; no repair loses much."""
    binary = folder / "long.stl"
    tdbd("mesh", folder / "cube.stl", "--repair", "-o", binary, "--binary", "--force")
    binary.write_bytes(binary.read_bytes() + bytes(80))
    read = tdbd("mesh", binary)
    assert read.returncode == 0 and read.stdout.splitlines()[1].split()[7] == "64000.000", read
    assert read.stderr == (f"tdbd: warning: {binary}: found 80 bytes after the 12 facets that the header declares; "
                           "they are ignored\n"), read
    bit = folder / "long.toml"
    bit.write_text("""name = "long"\n[[parts]]\nname = "a"\nkind = "face"\nfile = "long.stl"\nunit = "1 mm"\n""")
    read = tdbd("bit", bit)
    assert f"tdbd: warning: {bit}:5: parts[0].file: " in read.stderr and "found 80 bytes after the 12 facets" in read.stderr, read
    inner = CUBE + [(10 + x / 2, 10 + y / 2, 10 + z / 2) for x, y, z in CUBE]
    nested, out = folder / "nested.stl", folder / "nested-out.stl"
    nested.write_text(solid("a", SIDES + [tuple(v + 8 for v in t) for t in SIDES], inner))
    refused(tdbd("mesh", nested), "piece that bounds nothing: 12 facets", "8000 mm3, inside another piece")
    repaired = tdbd("mesh", nested, "--repair", "-o", out)
    assert repaired.returncode == 0 and "a: 12 facets dropped of shells" in repaired.stdout, repaired
    assert repaired.stdout.splitlines()[-1].split()[7] == "64000.000", repaired
    scattered = [(x + i % 5 * 1e-5, y + i % 3 * 1e-5, z) for i, (x, y, z) in enumerate(CUBE * 3)]
    near = folder / "near.stl"
    near.write_text(solid("a", [tuple(v + 8 * (i % 3) for v in t) for i, t in enumerate(SIDES)], scattered))
    refused(tdbd("mesh", near), "--repair --weld '0.0001 mm' -o ")
    for weld, code in (("0.0001 mm", 0), ("50 mm", 2)):
        done = tdbd("mesh", near, "--repair", "--weld", weld, "-o", folder / f"weld-{code}.stl")
        assert done.returncode == code and "CGAL" not in done.stdout + done.stderr, done
    assert not (folder / "weld-2.stl").exists()


def check_grading(folder):
    """Finer at the edges, coarser inside, the same cube; the digits of its corners stay."""
    out = folder / "graded.obj"
    graded = tdbd("mesh", folder / "cube.stl", "--grade", "--edge", "1 mm", "--face", "10 mm",
                  "-o", out)
    assert graded.returncode == 0 and "12 feature edges" in graded.stdout, graded
    row = tdbd("mesh", out).stdout.splitlines()[1].split()
    assert row[4:8] == ["yes", "yes", "yes", "64000.000"], row
    assert float(row[11]) < 1.34 and float(row[13]) > 5, row
    assert "v 40 40 40\n" in out.read_text()
    again = folder / "again.obj"
    tdbd("mesh", folder / "cube.stl", "--grade", "--edge", "1 mm", "--face", "10 mm", "-o", again)
    assert again.read_bytes() == out.read_bytes()
    even = tdbd("mesh", folder / "cube.stl", "--grade", "--edge", "8 mm", "--face", "8 mm", "--growth", "0", "-o",
                folder / "even.obj")
    assert even.returncode == 0, even
    refused(tdbd("mesh", folder / "cube.stl", "--grade", "--growth", "-0.1", "-o", folder / "no.obj"), "--growth: found -0.1")
    refused(tdbd("mesh", folder / "cube.stl", "--grade", "--edge", "3 mm", "--face", "2 mm", "-o",
                 folder / "no.obj"), "--face: found 2 mm, expected at least --edge")
    refused(tdbd("mesh", folder / "cube.stl", "--grade", "--repair", "-o", folder / "no.obj"),
            "found --repair as well")
    refused(tdbd("mesh", folder / "cube.stl", "--grade"), "--output: found no file")
    (folder / "open.stl").write_text(solid("a", SIDES[:-1]))
    refused(tdbd("mesh", folder / "open.stl", "--grade", "-o", folder / "no.obj"), "hole: 3 times",
            "to repair: tdbd mesh ")
    assert not (folder / "no.obj").exists()


def check_growth(folder):
    """The slower edges grow, the more of them there are; other solids are unchanged."""
    (folder / "two.stl").write_text(solid("a") + solid("b", points=[(x + 100, y, z) for x, y, z in CUBE]))
    facets = []
    for growth in ("0", "0.2", "2"):
        done = tdbd("mesh", folder / "two.stl", "--grade", "--only", "b*", "--edge", "4 mm", "--face", "20 mm", "--growth", growth,
                    "-o", folder / f"growth-{growth}.obj")
        assert done.returncode == 0 and "b: 12 facets to " in done.stdout and "a: " not in done.stdout, done
        facets.append(int(re.search("b: 12 facets to ([0-9]+),", done.stdout).group(1)))
        assert done.stdout.splitlines()[-2].split()[:3] == ["a", "8", "12"], done
    assert facets[0] > 1.2 * facets[1] > 1.2 * 1.2 * facets[2], facets


def check_usual_grading(folder):
    """The defaults in the help are those of the grading."""
    cube, told = folder / "cube.stl", tdbd("mesh", "--help").stdout
    options = ("--edge", "--face", "--growth", "--angle", "--deviation")
    usual = {o: re.search(rf"^  {o} [A-Z]+=(.+?)  ", told, re.MULTILINE) for o in options}
    assert all(usual.values()), told
    words = [word for option, match in usual.items() for word in (option, match[1])]
    assert words == ["--edge", "0.5 mm", "--face", "3 mm", "--growth", "0.5", "--angle", "25 deg", "--deviation", "0.005 mm"], words
    for name, given in (("usual", []), ("given", words)):
        done = tdbd("mesh", cube, "--unit", "0.1 mm", "--grade", *given, "-o", folder / f"{name}.obj")
        assert done.returncode == 0, done
    assert (folder / "usual.obj").read_bytes() == (folder / "given.obj").read_bytes()


def check_units(folder):
    """A cube of 40 mm read in m, and one of 40 m read in mm: both messages suggest the unit."""
    bit = folder / "unit.toml"
    for text in ('[solids]\nfile = "cube.stl"\n{}',
                 '[[parts]]\nname = "a"\nkind = "face"\nfile = "cube.stl"\n{}'):
        bit.write_text('name = "b"\n' + text.format('unit = "1 m"\n'))
        refused(tdbd("bit", bit), "unit: found a size of ", 'is it in mm (unit = "1 mm": ')
        bit.write_text('name = "b"\nunit_check = "off"\n' + text.format('unit = "1 m"\n'))
        assert tdbd("bit", bit).returncode == 0
    (folder / "small.stl").write_text(
        solid("cutter-1/face", points=[[x / 1000 for x in p] for p in CUBE]))
    bit.write_text('name = "b"\n[solids]\nfile = "small.stl"\n')
    refused(tdbd("bit", bit), "unit.toml:2: solids.unit: found a size of 0.113137 mm",
            'in m (unit = "1 m": 113.137 mm)')
    case = folder / "body.toml"
    body = '[body]\nmesh = "{}.stl"\ndensity = 7800\n{}[time]\nstep = 0.01\nduration = 0.1\n'
    case.write_text(body.format("small", ""))
    refused(tdbd("check", case), "body.unit: found a size of 0.04 mm, where a body has 10 to 20000")
    case.write_text(body.format("cube", 'unit = "1 m"\n'))
    refused(tdbd("check", case), "body.unit: found a size of 40000 mm", 'unit = "1 mm": 40 mm')
    case.write_text(body.format("cube", ""))
    assert tdbd("check", case).returncode == 0, tdbd("check", case)


def check_densities(folder):
    """Mass properties require the density of every part."""
    bit = folder / "mass.toml"
    bit.write_text('name = "b"\n[solids]\nfile = "cube.stl"\n')
    shown = tdbd("bit", bit)
    assert shown.returncode == 0 and "mass unknown: no density for cutter-1/face" in shown.stdout
    refused(tdbd("bit", bit, "--report", "-o", folder / "mass"), "no density of cutter-1/face",
            "mass.toml:")
    assert not (folder / "mass").exists()
    bit.write_text('name = "b"\n[[parts]]\nname = "a"\nkind = "face"\nfile = "cube.stl"\n')
    refused(tdbd("bit", bit, "--report", "-o", folder / "mass"),
            "mass.toml:2: parts[0].density: found none of a")
    bit.write_text('name = "b"\n[solids]\nfile = "cube.stl"\n[[solids.rules]]\nmatch = "*"\n'
                   'density = "7.8 g/cm3"\n')
    done = tdbd("bit", bit, "--report", "-o", folder / "mass")
    assert done.returncode == 0, done
    assert abs(json.loads((folder / "mass/analysis.json").read_text())["mass_kg"] - 0.4992) < 1e-12


def check_round_trips(folder):
    """A bit written whole reads back in every format with the same mass and parts."""
    def parts(result):
        assert result.returncode == 0, result
        lines = result.stdout.splitlines()
        first = next(i for i, line in enumerate(lines) if line.startswith("part "))
        assert len(lines) > first + 1 and "face" in lines[first + 1]
        return [line for line in lines if line.startswith("mass ")] + [line for line in lines[first:] if not line.startswith("wrote ")]

    for form in ("stl", "obj", "ply", "off"):
        original = tdbd("bit", BIT, "-o", folder / form, "--solids", form, "--parts")
        assert (folder / form / f"bit.{form}").stat().st_size > 0
        again = parts(tdbd("bit", folder / form / "solids.toml", "--parts"))
        assert parts(original) == again, form


def check_rock_of_a_run(folder):
    """The rock that a run wrote is in metres and is no body; the option for the unit applies to it."""
    case = pathlib.Path(BIT).parents[1] / "bit-b-steady.toml"
    done = tdbd("run", case, "-o", folder / "run", "--quiet", "--set", "rock.edge_length=8 mm", "--set", "time.revolutions=0.01")
    assert done.returncode == 0, done
    rock = folder / "run/rock_final.ply"
    told = tdbd("mesh", rock)
    assert told.returncode == 0 and "the rock of a run after 5 steps" in told.stdout, told
    row = told.stdout.splitlines()[1].split()
    assert 200 < float(row[8]) < 220, row  # mm across
    refused(tdbd("mesh", rock, "--unit", "1 mm"), "--unit: found 1 mm, but the header of ", "states the unit m")
    bare = folder / "bare.ply"
    bare.write_bytes(b"".join(line for line in rock.read_bytes().splitlines(keepends=True)
                              if not line.startswith(b"comment tdbd")))
    tiny = tdbd("mesh", bare, "--sheet", "--unit", "1 mm").stdout.splitlines()[-2].split()
    assert 0.2 < float(tiny[8]) < 0.22, tiny
    refused(tdbd("mesh", bare), "hole", "tdbd mesh --sheet inspects it")


def check_many_solids(folder):
    """Of many solids a few are listed, the faults before them; an edge that four decimals would hide is in micrometres."""
    many = folder / "many.stl"
    many.write_text("".join(solid(f"s-{k}", SIDES[:-1]) for k in range(40)))
    both = subprocess.run([PROGRAM, "mesh", str(many)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout.splitlines()
    assert both[0].startswith("tdbd: ") and len([line for line in both if line.startswith(("s-", "solid ", "and "))]) == 12, both
    refused(tdbd("mesh", many), "hole: 3 times", "to try a repair: tdbd mesh")
    short = [*CUBE[:-1], (0, 0.00035, 40)]
    (folder / "short.stl").write_text(solid("short", SIDES, short))
    row = tdbd("mesh", folder / "short.stl").stdout.splitlines()[1]
    assert "40.000  0.35 um  45.8479" in row, row


def sheet_obj(z=0.0, holes=(), flipped=False, cells=8):
    """A square sheet of 40 mm that faces against z; every hole is a cell, (column, row)."""
    side = cells + 1
    lines = [f"v {5 * i} {5 * j} {z}" for j in range(side) for i in range(side)]
    for j in range(cells):
        for i in range(cells):
            if (i, j) in holes:
                continue
            a = j * side + i + 1
            for t in ((a, a + side + 1, a + 1), (a, a + side, a + side + 1)):
                lines.append("f {} {} {}".format(*(t[::-1] if flipped else t)))
    return "\n".join(lines) + "\n"


def check_sheets(folder):
    """An open sheet is inspected as rock; its holes have places; it is changed only into a sheet that a case accepts."""
    good, bad, out = folder / "good.obj", folder / "holes.obj", folder / "sheet.ply"
    good.write_text(sheet_obj())
    told = tdbd("mesh", good, "--sheet")
    assert told.returncode == 0 and "rim of 32 edges, 56.57 mm across, at (20.0000, 20.0000, 0.0000) mm" in told.stdout, told
    row, last = told.stdout.splitlines()[-2:]
    assert row.split()[:8] == ["sheet", "81", "128", "1", "-", "-", "yes", "-"] and last.startswith("can be the rock of a case"), told
    bad.write_text(sheet_obj(z=1, holes=((2, 2), (6, 1)), flipped=True))
    told = tdbd("mesh", bad, "--sheet")
    refused(told, "wrong number of boundary loops: found 3, expected 1", "--fill-holes fills the holes inside the rim")
    assert told.stdout.count("hole of 4 edges, 7.071 mm across, at (") == 2, told
    assert "(12.5000, 12.5000, 1.0000) mm" in told.stdout and "(32.5000, 7.5000, 1.0000) mm" in told.stdout, told
    refused(tdbd("mesh", bad, "--fill-holes"), "--output: found no file")
    filled = tdbd("mesh", bad, "--fill-holes", "-o", out)
    refused(filled, "the facets face down, into the rock (z points down): does z point down in the file?", "--flip")
    assert "holes filled: 2" in filled.stdout and not out.exists(), filled
    refused(tdbd("mesh", bad, "--fill-holes", "--repair", "-o", out), "--sheet: found --repair or --grade as well")
    for how, z in (("--flip", "1"), ("--z-up", "-1")):
        done = tdbd("mesh", bad, "--fill-holes", how, "-o", out, "--force")
        assert done.returncode == 0 and f"wrote {out} in mm" in done.stdout, done
        told = tdbd("mesh", out, "--sheet")
        assert told.returncode == 0 and f"20.0000, {z}.0000) mm" in told.stdout, told
    assert told.stderr == "", told
    small = tdbd("mesh", good, "--sheet", "--unit", "0.01 mm")
    assert small.returncode == 0, small
    assert "warning: " in small.stderr and ("a size of 0.4 mm, where the rock of a case has 5 to 5000 mm: is it in mm (unit = \"1 mm\": 40 mm)"
                                            in small.stderr), small
    (folder / "two.obj").write_text(sheet_obj(holes=((2, 2), (4, 4), (4, 5))))
    assert "hole of 6 edges" in tdbd("mesh", folder / "two.obj", "--sheet").stdout


def cracked_stl(cells=12, seed=1):
    """A binary STL of a cube of 40 mm whose triangles have points of their own, up to 0.0002 mm apart."""
    random, facets = Random(seed), b""
    for axis in range(3):
        for end in (0, 40):
            for i in range(cells):
                for j in range(cells):
                    u, v = (40 * i / cells, 40 * (i + 1) / cells), (40 * j / cells, 40 * (j + 1) / cells)
                    square = [(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])]
                    for corners in ((0, 1, 2), (0, 2, 3)):
                        points = []
                        for a, b in (square[k] for k in (corners if end else corners[::-1])):
                            point = {0: [end, a, b], 1: [b, end, a], 2: [a, b, end]}[axis]
                            points += [x + random.uniform(-1e-4, 1e-4) for x in point]
                        facets += struct.pack("<12fH", 0, 0, 0, *points, 0)
    return b"x" * 80 + struct.pack("<I", len(facets) // 50) + facets


def check_cracks(folder):
    """A soup of triangles: few lines, and the command that they suggest repairs it."""
    soup = folder / "soup.stl"
    soup.write_bytes(cracked_stl())
    found = tdbd("mesh", soup)
    refused(found, "and 1716 more", "5184 edges are open because points that should coincide differ slightly",
            "with --weld '0.001 mm' 0 edges are open", "--repair --weld '0.001 mm' -o ")
    assert len(found.stdout.splitlines()) + len(found.stderr.splitlines()) < 60, found
    bare = tdbd("mesh", soup, "--repair", "-o", folder / "no.stl")
    refused(bare, "with --weld '0.001 mm'")
    assert len(bare.stderr.splitlines()) == 2 and not (folder / "no.stl").exists(), bare
    command = shlex.split(re.search("to repair: tdbd (.*)", found.stderr).group(1))
    done = tdbd(*command)
    assert done.returncode == 0 and done.stderr == "", done
    row = tdbd("mesh", command[-1]).stdout.splitlines()[1].split()
    assert row[:5] == ["solid-1", "866", "1728", "1", "yes"] and 63999 < float(row[7]) < 64001, row
    bit = folder / "soup.toml"
    bit.write_text('name = "b"\n[solids]\nfile = "soup.stl"\n')
    refused(tdbd("bit", bit), "--repair --weld '0.001 mm' -o ")


def check_stated_units(folder):
    """A mesh in a stated unit needs no --unit; another one is an error with both values. --binary and --output-unit."""
    cube, metres = folder / "cube.stl", folder / "metres.stl"
    done = tdbd("mesh", cube, "--grade", "-o", metres, "--output-unit", "m", "--binary", "--edge", "8 mm", "--face", "8 mm")
    assert done.returncode == 0 and f"wrote {metres} in m\n" in done.stdout, done
    assert metres.read_bytes().startswith(b"tdbd unit m "), metres.read_bytes()[:80]
    row = tdbd("mesh", metres).stdout.splitlines()[1].split()
    assert row[4:7] == ["yes"] * 3 and row[8] == "40.000", row
    refused(tdbd("mesh", metres, "--unit", "mm"), "--unit: found 1 mm, but the header of ", "metres.stl states the unit m")
    refused(tdbd("mesh", cube, "--output-unit", "kg", "--grade", "-o", folder / "no.stl"), "--output-unit: found 'kg'")
    bit = folder / "stated.toml"
    for text in ('[solids]\nfile = "metres.stl"\n{}[[solids.rules]]\nmatch = "*"\nkind = "face"\n',
                 '[[parts]]\nname = "a"\nkind = "face"\nfile = "metres.stl"\n{}'):
        bit.write_text('name = "b"\n' + text.format(""))
        assert "63999.996" in tdbd("bit", bit, "--parts").stdout, tdbd("bit", bit)  # in single precision
        bit.write_text('name = "b"\n' + text.format('unit = "1 mm"\n'))
        refused(tdbd("bit", bit), "unit: found 1 mm, but the header of ", "states the unit m", "or no unit")
    case = folder / "stated-body.toml"
    case.write_text('[body]\nmesh = "metres.stl"\ndensity = 7800\nunit = \"1 mm\"\n[time]\nstep = 0.01\nduration = 0.1\n')
    refused(tdbd("check", case), "stated-body.toml:4: body.unit: found 1 mm, but the header of ", "states the unit m")


with tempfile.TemporaryDirectory() as name:
    test_folder = pathlib.Path(name)
    for check in (check_inspection, check_repairs, check_conversions, check_refused_repairs, check_grading, check_growth,
                  check_usual_grading, check_units, check_densities, check_round_trips, check_rock_of_a_run, check_many_solids, check_sheets,
                  check_cracks, check_stated_units, check_field_files):
        check(test_folder)
