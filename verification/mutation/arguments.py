"""The words of scripts/mutate; a wrong one ends it with what was found and what is expected, exit code 2."""

import argparse
import pathlib
import shutil
import sys

from rooms import PROGRAMS, ROOT, room_problem

USAGE = """scripts/mutate [ROOM ...] [--count N] [--seed S]: seeds faults and asks whether the tests notice

One line of a source is changed, its object compiled, and the tests run until one fails: its own first, then the room's,
then those of other rooms. Without a ROOM: all of them."""


class Wrong(Exception):
    """What was found, and what is expected."""


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Wrong(message)


def whole_number(least):
    def read(word):
        if not word.isdigit() or int(word) < least:
            raise argparse.ArgumentTypeError(f"found {word}, expected a whole number from {least}")
        return int(word)
    return read


def parse(words):
    parser = Parser(prog="scripts/mutate", description=USAGE, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rooms", nargs="*", metavar="ROOM")
    parser.add_argument("--count", type=whole_number(1), default=100, metavar="N", help="mutants of each room (100)")
    parser.add_argument("--seed", type=whole_number(0), default=2007, metavar="S", help="of the draw (2007)")
    parser.add_argument("--only", default="", metavar="WORD", help="mutants of sources with WORD in their path, or WORD = PATH:LINE")
    parser.add_argument("--home", action="store_true", help="runs the room's own programs alone")
    parser.add_argument("--longest", type=float, default=float("inf"), metavar="S", help="leaves out tests that take longer, unmutated")
    parser.add_argument("--table", type=pathlib.Path, metavar="CSV", help="writes the verdicts there, in place of the room's rows; asks first what killed a mutant there before")
    parser.add_argument("--check", action="store_true", help="says which entries of equivalent.toml are no longer in the source; runs nothing")
    parser.add_argument("--targets", action="store_true", help="prints what must be built; runs nothing")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/mutate", metavar="FOLDER")
    chosen = parser.parse_args(words)
    for room in chosen.rooms:
        if problem := room_problem(room):
            raise Wrong(problem)
    chosen.rooms = chosen.rooms or list(PROGRAMS)
    return chosen


def require_tools():
    for tool in ("ninja", "c++"):
        if shutil.which(tool) is None:
            raise Wrong(f"found no {tool}, expected it: bash scripts/setup mutate installs it")


def fail(why):
    print(f"mutate: {why}", file=sys.stderr)
    return 2
