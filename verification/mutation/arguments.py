"""The command line of scripts/mutate. A bad argument ends it with exit code 2 and a message: what was found, what is expected."""

import argparse
import pathlib
import shutil
import sys

from modules import PROGRAMS, ROOT, module_problem, unknown_modules

USAGE = """scripts/mutate [MODULE ...] [--count N] [--seed S]: seeds faults and counts those that the tests detect

Changes one line of a source, compiles its object, and runs the tests until one fails: first those of the source, then those
of its module (MODULE, a folder of src), then those of other modules. Default: all modules."""


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
    parser.add_argument("modules", nargs="*", metavar="MODULE")
    parser.add_argument("--count", type=whole_number(1), default=100, metavar="N", help="mutants of each module (100)")
    parser.add_argument("--seed", type=whole_number(0), default=2007, metavar="S", help="seed of the draw (2007)")
    parser.add_argument("--only", default="", metavar="WORD", help="only mutants of sources with WORD in their path, or of the line PATH:LINE")
    parser.add_argument("--home", action="store_true", help="runs only the programs of the module itself")
    parser.add_argument("--longest", type=float, default=float("inf"), metavar="S", help="leaves out tests that take longer than S seconds without a mutant")
    parser.add_argument("--table", type=pathlib.Path, metavar="CSV", help="writes the verdicts to this table, replacing the rows of the module; a test that killed a mutant there before runs first")
    parser.add_argument("--check", action="store_true", help="prints the entries of equivalent.toml that match no line of src any more; runs nothing")
    parser.add_argument("--targets", action="store_true", help="prints what must be built; runs nothing")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/mutate", metavar="FOLDER")
    chosen = parser.parse_args(words)
    if not chosen.modules and unknown_modules():
        raise Wrong(f"verification/mutation/modules.py: found no test programs for {', '.join(unknown_modules())}, expected some for each folder of src")
    for module in chosen.modules:
        if problem := module_problem(module):
            raise Wrong(problem)
    chosen.modules = chosen.modules or list(PROGRAMS)
    return chosen


def require_tools():
    for tool in ("ninja", "c++"):
        if shutil.which(tool) is None:
            raise Wrong(f"found no {tool}, expected it: bash scripts/setup mutate installs it")


def fail(why):
    print(f"mutate: {why}", file=sys.stderr)
    return 2
