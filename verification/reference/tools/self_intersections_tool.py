"""self_intersections_tool.py PROGRAM: counts a piercing pair, and refuses what it cannot judge."""

import pathlib
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
POINTS = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, 1), (2, 1, 2), (1, 2, 2)]


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def figures(result):
    """The printed figures, name to value."""
    rows = [line.rsplit(maxsplit=1) for line in result.stdout.splitlines() if line[0] != " "]
    return {name: float(value) for name, value in rows}


def write(path, points, triangles):
    """A PLY file with text numbers, which may be any."""
    rows = [" ".join(map(str, p)) for p in points] + ["3 " + " ".join(map(str, t)) for t in triangles]
    path.write_text(
        "ply\nformat ascii 1.0\n" + f"element vertex {len(points)}\n"
        + "".join(f"property double {axis}\n" for axis in "xyz")
        + f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
        + "\n".join(rows) + "\n", encoding="ascii")
    return path


def check_counts(folder):
    apart = run(write(folder / "apart.ply", POINTS, [(0, 1, 2), (3, 4, 5)]))
    assert apart.returncode == 0, apart
    counted = figures(apart)
    assert counted["self-intersecting pairs"] == 0, counted
    assert (counted["triangles"], counted["vertices"]) == (2, 6), counted
    assert abs(counted["worst quality"] - 12 ** 0.5 / 4) < 1e-4, counted  # a right angle's
    pierced = POINTS[:3] + [(1, 1, -1)] + POINTS[4:]
    crossing = run(write(folder / "crossing.ply", pierced, [(0, 1, 2), (3, 4, 5)]))
    assert crossing.returncode == 1 and figures(crossing)["self-intersecting pairs"] == 1, crossing
    assert "triangles 0 and 1" in crossing.stdout, crossing


def check_refusals(folder):
    assert run("--help").returncode == 0 and "Usage" in run("--help").stdout
    empty = write(folder / "empty.ply", POINTS, [])
    fan = write(folder / "fan.ply", POINTS, [(0, 1, 2), (0, 1, 3)])
    hole = write(folder / "nan.ply", POINTS[:5] + [("nan", 2, 2)], [(0, 1, 2), (3, 4, 5)])
    for arguments, reason in (((), "Usage"), (("--fast",), "Usage"), ((empty, empty), "Usage"),
                              ((folder / "none.ply",), "no such file"), ((PROGRAM,), "format"),
                              ((empty,), "empty.ply"), ((fan,), "manifold"), ((hole,), "nan.ply")):
        result = run(*arguments)
        assert result.returncode == 2 and reason in result.stderr, (arguments, result)
        assert result.stdout == "", result


with tempfile.TemporaryDirectory() as name:
    check_counts(pathlib.Path(name))
    check_refusals(pathlib.Path(name))
