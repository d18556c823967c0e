#!/usr/bin/python3
"""Draws a result of TDBD. `tdbd draw` calls this script.

    reports/draw.py RESULT ... [-o DIR] [--gif FILE]

Of a run: bit.png, bottom_hole.png, side_view.png, cutters.png, forces.png (with forces), traces.png. Of a rotation: motion.png, path.png,
conservation.png. Of a drill string: torque_and_drag.png, broomstick.png, modes.png, and of a run traces.png and time_depth.png. Of a
convergence study: convergence.png, and of a rotation work_precision.png. Of a calibration: coefficients.png, predictions.png. Of the
table of a sweep: the pictures of sweep.py. Of a curve: curve.png. Several folders of rotations or of their convergence studies: one work_precision.png.
Exit code 2 and a message for anything else.
"""

import argparse
import subprocess
import sys
from pathlib import Path

import system_python

system_python.require("matplotlib", "numpy", "netCDF4")

import matplotlib

matplotlib.use("Agg")

import curve
import result_kind
import result_pictures
from progress import Progress
from result_kind import NoResult

HERE = Path(__file__).resolve().parent
INSTEAD = {"bit": "tdbd report FOLDER makes its page", "models": "its tables are comparison.csv and comparison.nc in the folder"}


def draw_sweep(table, output):
    """The pictures of sweep.py, which prints their names."""
    words = [sys.executable, "-B", str(HERE / "sweep.py"), str(table), *(["-o", str(output)] if output else [])]
    if subprocess.run(words, check=False).returncode:
        raise NoResult(f"{table}: the table was not drawn")


def draw_curve(folder, output):
    """The picture of curve.py. Raises NoResult."""
    try:
        print(curve.draw_curve(folder, output))
    except ValueError as error:
        raise NoResult(str(error)) from error


def save_all(pictures, summary, output):
    """Saves pictures one after another and prints their names."""
    output.mkdir(parents=True, exist_ok=True)
    for picture in Progress("draw", len(pictures), "picture").over(pictures, lambda p: p.name):
        path = output / f"{picture.name}.png"
        result_pictures.save(picture, summary, path)
        print(path, flush=True)


def draw_one(path, output):
    """All pictures of one result. Raises NoResult."""
    kind = result_kind.kind_of(path)
    if kind == "sweep":
        return draw_sweep(path, output)
    if kind == "curve":
        return draw_curve(path, output or path)
    if kind not in result_pictures.DRAWN:
        raise NoResult(f"{path}: found {result_kind.NAMES[kind]}, of which there are no pictures; {INSTEAD[kind]}")
    summary, pictures = result_pictures.of_folder(path, kind)
    return save_all(pictures, summary, output or path)


def draw_together(paths, output):
    """A work-precision diagram of several rotations or studies of rotations. Raises NoResult."""
    from figures import work_precision

    kinds = {path: result_kind.kind_of(path) for path in paths}
    for path, kind in kinds.items():
        if kind not in ("rotation", "convergence") or kind != kinds[paths[0]]:
            raise NoResult(f"{path}: found {result_kind.NAMES[kind]}, expected several rotations or several convergence studies of rotations "
                           "(one work-precision diagram), or one result")
    summary = result_kind.read(paths[0] / ("summary.json" if kinds[paths[0]] == "rotation" else "convergence.json"))
    make = work_precision.of_runs if kinds[paths[0]] == "rotation" else work_precision.of_studies
    save_all([result_pictures.Picture("work_precision", "Work and precision", "", lambda: make(paths))], summary, output or Path())


def check_gif(paths):
    """Raises NoResult unless there is one run, before anything is drawn."""
    if len(paths) > 1:
        raise NoResult(f"--gif: found {len(paths)} results, expected one run")
    result_kind.demand(paths[0], ("run",))


def draw_gif(path, gif):
    import animate

    animate.animate(path, gif)
    print(gif)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=Path, nargs="+", help="result folders, or the table of a sweep (NAME.nc)")
    parser.add_argument("-o", "--output", type=Path, help="folder of the pictures (the result folder)")
    parser.add_argument("--gif", type=Path, help="also an animation of a run with frames")
    chosen = parser.parse_args(arguments)
    try:
        if chosen.gif:
            check_gif(chosen.results)
        if len(chosen.results) == 1:
            draw_one(chosen.results[0], chosen.output)
        else:
            draw_together(chosen.results, chosen.output)
        if chosen.gif:
            draw_gif(chosen.results[0], chosen.gif)
    except (OSError, LookupError, ValueError) as error:
        print(f"draw: {error if isinstance(error, (OSError, ValueError)) else f'{chosen.results[0]}: found a result without {error}'}",
              file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
