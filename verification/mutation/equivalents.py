"""Mutants that are known to be equivalent to the source: no input distinguishes the two. equivalent.toml lists them with the reason."""

import pathlib
import tomllib

import mutants
from modules import ROOT

LIST = ROOT / "reports/studies/mutation/equivalent.toml"
KEYS = {"function", "line", "mutation", "reason"}


def folded(line):
    """The line with single spaces, so that another indentation does not change it."""
    return " ".join(line.split())


def read(path=LIST):
    """{(function, line, mutation): reason}."""
    with pathlib.Path(path).open("rb") as file:
        entries = tomllib.load(file).get("equivalent", [])
    judged = {}
    for number, entry in enumerate(entries, 1):
        if set(entry) != KEYS or not all(isinstance(v, str) and v for v in entry.values()):
            raise ValueError(f"{path}: entry {number}: found the keys {', '.join(entry)}, expected text for each of {', '.join(sorted(KEYS))}")
        judged[entry["function"], folded(entry["line"]), folded(entry["mutation"])] = entry["reason"]
    return judged


def key(mutant):
    return mutant.function, folded(mutant.before), folded(mutant.after)


def stale(judged, root=ROOT):
    """A message for each entry that no mutant of src matches."""
    made = {key(mutant) for file in sorted((root / "src").rglob("*.cpp"))
            for mutant in mutants.of_source(str(file.relative_to(root)), file.read_text(encoding="utf-8"))}
    functions = {function for function, _, _ in made}
    places = {}
    for function, line, mutation in made:
        places.setdefault((line, mutation), []).append(function)
    problems = []
    for function, line, mutation in judged:
        if (function, line, mutation) in made:
            continue
        if (line, mutation) in places:
            why = f"the line is in {', '.join(sorted(places[line, mutation]))}"
        elif function not in functions:
            why = "src has no such function"
        elif line in {before for name, before, _ in made if name == function}:
            why = f"no operator makes {mutation!r} of it"
        else:
            why = "the function has no such line"
        problems.append(f"{function}: {line!r}: {why}")
    return problems
