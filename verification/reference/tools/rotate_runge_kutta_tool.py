"""rotate_runge_kutta_tool.py PROGRAM TDBD CASES: runs a case, agrees with the program, refuses bad input."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

PROGRAM, TDBD, CASES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def lines(*arguments):
    result = run(*arguments)
    assert result.returncode == 0, result
    return [json.loads(line) for line in result.stdout.splitlines()]


def check_ladder(method, numbers):
    """More accuracy costs more and errs less."""
    points = lines(CASES / "slow-top.toml", method, *numbers)
    assert [p["accuracy"] for p in points] == numbers and {p["method"] for p in points} == {method}
    for coarse, fine in zip(points, points[1:]):
        assert fine["torque_evaluations"] > coarse["torque_evaluations"], (coarse, fine)
        assert fine["attitude_error_rad"] < coarse["attitude_error_rad"], (coarse, fine)
    assert points[-1]["attitude_error_rad"] < 1e-6, points[-1]


def check_against_program(case, settings):
    """The eighth-order composition and rk8pd reach the same end, in attitude, momenta and angles."""
    with tempfile.TemporaryDirectory() as folder:
        flags = [word for s in settings for word in ("--set", s)]
        fine = ["--set", "integrator.order=8", "--set", "time.step=0.005 s"]
        done = subprocess.run([TDBD, "rotate", CASES / case, "-o", folder + "/r", "--quiet", *flags, *fine],
                              capture_output=True, text=True)
        assert done.returncode == 0, done
        ours = json.loads(pathlib.Path(folder, "r", "summary.json").read_text(encoding="utf-8"))
    twin, = lines(CASES / case, "rk8pd", 1e-15, *flags)
    for key in ("attitude", "body_momentum", "cone_angles", "cone_momenta"):
        for a, b in zip(flat(ours[key]), flat(twin[key]), strict=True):
            assert math.isclose(a, b, rel_tol=1e-10, abs_tol=1e-10), (case, key, ours[key], twin[key])


def flat(values):
    return [x for v in values for x in flat(v)] if isinstance(values, list) else [values]


def check_refusals():
    assert run("--help").returncode == 0 and "Usage" in run("--help").stdout
    case = CASES / "slow-top.toml"
    for arguments, reason in (((), "Usage"), ((case, "rk8pd"), "Usage"), ((case, "rk3", 1e-6), "rk3"),
                              ((case, "rk8pd", "fine"), "fine"), ((case, "rk8pd", "nan"), "nan"),
                              ((case, "rkf45", -1e-3), "-0.001"), ((case, "rk4", 2.5), "2.5"),
                              ((case, "rk4", 100, "--set"), "KEY=VALUE"),
                              ((case, "rk4", 100, "--set", "body.inertio=1"), "inertio"),
                              ((CASES / "none.toml", "rk4", 100), "none.toml")):
        result = run(*arguments)
        assert result.returncode == 2 and reason in result.stderr, (arguments, result)
        assert result.stdout == "", result


check_ladder("rk8pd", [1e-4, 1e-7, 1e-10])
check_ladder("rkf45", [1e-4, 1e-7, 1e-10])
check_ladder("rk4", [400, 1600, 6400])
check_against_program("heavy-gyrostat.toml", ["time.duration=5 s"])
check_against_program("applied-torque.toml", ["time.duration=5 s", "load.stiffness=[3, 3, 2]"])
check_refusals()
