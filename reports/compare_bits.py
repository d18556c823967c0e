#!/usr/bin/python3
"""Compares two bits on one page. `tdbd compare` calls this script.

    reports/compare_bits.py A B -o FILE --program build/release/tdbd [--penetration M] [--speed RAD_PER_S] [--strength PA]

A and B are two bit files (TOML), whose forces are estimated from their cut areas, or two result folders of tdbd run with forces, whose
forces are those of the runs. Options have SI units. Exit code 2 and a message for anything else.
"""

import argparse
import math
import os
import sys
import tempfile
from pathlib import Path

import system_python

system_python.require("jinja2", "matplotlib", "numpy", "netCDF4")

import jinja2
import matplotlib

matplotlib.use("Agg")

import compared_bits
import run_facts
from figures import bit_comparison
from progress import Progress
from result_kind import NoResult
from run_report import DPI, embedded, write_whole

HERE = Path(__file__).resolve().parent
SAME = 1e-9  # relative differences below are rounding


def read_sides(paths, program, operation, folder):
    """Both bits. Raises NoResult."""
    are_runs = [path.is_dir() for path in paths]
    if are_runs[0] != are_runs[1]:
        kinds = ["a folder" if is_run else "a bit file" for is_run in are_runs]
        raise NoResult(f"found {kinds[0]} ({paths[0]}) and {kinds[1]} ({paths[1]}), expected two bit files or two result folders of tdbd run")
    if are_runs[0]:
        sides = [compared_bits.of_run(path) for path in paths]
    else:
        sides = [compared_bits.of_bit(path, folder / letter, program, operation) for path, letter in zip(paths, "ab")]
    if sides[0].name == sides[1].name:
        for side, letter, path in zip(sides, "AB", paths):
            side.name = f"{letter}: {path.stem}" if paths[0].stem != paths[1].stem else f"{letter}: {side.name}"
    return sides


def difference_row(what, a, b):
    """Texts of one line of the table of differences."""
    if isinstance(a, int) and isinstance(b, int):
        return (what, str(a), str(b), f"{b - a:+d}" if b != a else "0", f"{100 * (b - a) / a:+.1f} %" if a and b != a else "")
    if None in (a, b) or not (math.isfinite(a) and math.isfinite(b)):
        return (what, *("-" if x is None else run_facts.number(x) for x in (a, b)), "", "")
    if abs(b - a) <= SAME * max(abs(a), abs(b)):
        return (what, run_facts.number(a), run_facts.number(b), "0", "")
    sign = "+" if b > a else ""
    return (what, run_facts.number(a), run_facts.number(b), sign + run_facts.number(b - a, 3), f"{100 * (b - a) / a:+.1f} %" if a else "")


def differences(sides):
    names = dict.fromkeys(name for side in sides for name in side.sums)
    return [difference_row(name, *(side.sums.get(name) for side in sides)) for name in names]


def cutter_rows(sides):
    """A line for each number of a cutter: radius, normal force, drag and work rate of both bits."""
    def cells(side, k):
        if k >= len(side.radius):
            return ("", "", "", "")
        return tuple(run_facts.number(v, 3) for v in (1e3 * side.radius[k], 1e-3 * side.normal[k], 1e-3 * side.drag[k], side.power[k]))

    return [(k + 1, *cells(sides[0], k), *cells(sides[1], k)) for k in range(max(len(s.radius) for s in sides))]


def charts(sides):
    """[(title, caption, function that draws it)]."""
    found = [("Profiles", "In one half-plane, the lowest points at the same height. Thick: the exposure profile. Thin: the rims of the cutters.",
              bit_comparison.profile), ("Forces of the cutters", "Over the radius of the tip.", bit_comparison.forces),
             ("Work rates", "Power that each cutter spends on the rock.", bit_comparison.work),
             ("Lateral forces", "On the bit, over its weight, in the frame of the bit. Seen from above, z away from the reader.", bit_comparison.pushes)]
    if all(side.mesh is not None for side in sides):
        found.insert(0, ("The bits", "From below, on one scale.", lambda s: bit_comparison.views(s, DPI)))
    return found


def assumptions(paths, operation):
    if paths[0].is_dir():
        return "Forces are the means of two runs. Compare runs in the same rock, at the same speed, and at the same rate or weight."
    return (f"Forces are an estimate for steady drilling at {1e3 * operation.penetration:.4g} mm a revolution and "
            f"{operation.speed * 30 / math.pi:.4g} rpm in rock of {1e-6 * operation.strength:.4g} MPa: cut areas times "
            f"{compared_bits.NORMAL_OVER_STRENGTH:.1f} strengths (normal force, along the normal of the profile) and "
            f"{compared_bits.DRAG_OVER_STRENGTH:.1f} strengths (drag). Chamfers, wear, rakes and the bodies of the bits have no effect on "
            "them. Ratios of the two bits are more certain than the values. For forces of a law, run both bits with tdbd run and compare "
            "the result folders.")


def html_of(paths, program, operation):
    with tempfile.TemporaryDirectory() as folder:
        sides = read_sides(paths, program, operation, Path(folder))
    listed = charts(sides)
    drawn = [{"title": title, "caption": caption, "image": embedded(draw(sides))}
             for title, caption, draw in Progress("compare", len(listed), "chart").over(listed, lambda c: c[0])]
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
                                     undefined=jinja2.StrictUndefined, lstrip_blocks=True)
    return environment.get_template("compare_bits.html.j2").render(
        names=[side.name for side in sides], assumptions=assumptions(paths, operation), differences=differences(sides), charts=drawn,
        cutters=cutter_rows(sides)), sides


def print_differences(sides):
    """The main differences, for the terminal."""
    rows = [row for row in differences(sides) if row[3] != "0"]
    width = max(len(row[0]) for row in rows) if rows else 0
    print(f"{'':<{width}} {sides[0].name[:18]:>18} {sides[1].name[:18]:>18}  difference")
    for what, a, b, _, percent in rows:
        print(f"{what:<{width}} {a:>18} {b:>18}  {percent or _}")


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bits", type=Path, nargs=2, help="two bit files, or two result folders of tdbd run")
    parser.add_argument("-o", "--output", type=Path, default=Path("comparison.html"), help="the page (comparison.html)")
    parser.add_argument("--program", type=Path, default=HERE.parent / "build" / "release" / "tdbd", help="the program tdbd")
    parser.add_argument("--penetration", type=float, default=0.005, help="advance, m per revolution (0.005)")
    parser.add_argument("--speed", type=float, default=4.0 * math.pi, help="rotary speed, rad/s (12.57)")
    parser.add_argument("--strength", type=float, default=60e6, help="strength of the rock, Pa (60e6)")
    chosen = parser.parse_args(arguments)
    try:
        if not chosen.bits[0].is_dir() and not os.access(chosen.program, os.X_OK):
            raise NoResult(f"--program {chosen.program}: found no program, expected tdbd")
        operation = compared_bits.Operation(chosen.penetration, chosen.speed, chosen.strength)
        page, sides = html_of(chosen.bits, chosen.program, operation)
        write_whole(chosen.output, page)
    except (OSError, LookupError, ValueError) as error:
        print(f"compare: {error if isinstance(error, (OSError, ValueError)) else f'found a result without {error}'}", file=sys.stderr)
        return 2
    print_differences(sides)
    if not chosen.bits[0].is_dir():
        print("loads are estimates that ignore rakes, chamfers, wear and the bodies of the bits: compare two runs to include them")
    print(f"compare: look at {chosen.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
