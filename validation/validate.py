"""validate.py [-o DIR] [--chapter6] [NAME ...]: runs the cases of split.toml with `tdbd calibrate`, then compare.py.

DIR: results/validation. Each case has a folder in DIR; cut runs are kept in DIR/cuts and made once.
NAME: only these comparisons. --chapter6: also runs chapter6/make.py with the output DIR/chapter6,
unless there is a NAME. --program: another tdbd."""

import argparse
import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

import compare
import comparison

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent


def chosen(split, names):
    """Returns the comparisons with these names, or all of them without names."""
    known = [c["name"] for c in split]
    for name in names:
        if name not in known:
            raise comparison.Problem(f"found no comparison '{name}', expected one of {', '.join(known)}")
    return [c for c in split if not names or c["name"] in names]


def runs(split):
    """Returns [(case, case from which it takes coefficients, or None)], each after the case that it requires."""
    order = {}
    for c in split:
        for law in c["law"].values():
            before = law.get("coefficients_from")
            if before:
                order.setdefault(before)
            order[law["case"]] = before
    return list(order.items())


def starts(results, case, before):
    """Options that pass coefficients found by another case: as starts if they are fitted, otherwise as fixed values."""
    if before is None:
        return []
    found = json.loads((results / before / "calibration.json").read_text(encoding="utf-8"))["coefficients"]
    unknowns = tomllib.loads(case.read_text(encoding="utf-8")).get("unknowns", {})
    options = []
    for key, c in found.items():
        place = f"unknowns.{key}.start" if key in unknowns else f"fixed.{key}"
        options += ["--set", f"{place}={c['value']!r}" + ("" if c["unit"] == "1" else f" {c['unit']}")]
    return options


def calibrate(program, case, results, before, options=()):
    """Runs one case and prints its messages only if it fails."""
    file = HERE / "cases" / f"{case}.toml"
    command = [str(program), "calibrate", str(file), "-o", str(results / case), "--force", "--quiet", "--threads",
               str(os.cpu_count()), *starts(results, file, before), *options]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise comparison.Problem(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stderr.strip()}")


def validate(program, results, names):
    split = chosen(comparison.read_split(), names)
    results.mkdir(parents=True, exist_ok=True)
    for case, before in runs(split):
        calibrate(program, case, results, before)
    code = compare.report(compare.compare(results, split))
    print(f"tables and figures: {results / 'comparisons.md'}, {results / 'comparison-*.png'}")
    return code


def chapter6(program, results):
    """Makes chapter 6 and appendix D with the synthetic laboratory."""
    folder = results / "chapter6"
    code = subprocess.run([sys.executable, "-B", HERE / "chapter6/make.py", program, folder], check=False).returncode
    if code == 0:
        print(f"chapter 6 and appendix D, synthetic laboratory: {folder / 'tables'}, {folder / 'figures'}")
    return code


def main(act=validate, what=__doc__):
    parser = argparse.ArgumentParser(description=what, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "results" / "validation", metavar="DIR")
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "release" / "tdbd")
    parser.add_argument("--chapter6", action="store_true")
    parser.add_argument("names", nargs="*", metavar="NAME")
    a = parser.parse_args()
    try:
        code = act(a.program, a.output.resolve(), a.names)
        return chapter6(a.program, a.output.resolve()) or code if a.chapter6 and not a.names else code
    except comparison.Problem as problem:
        print(f"validate: {problem}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
