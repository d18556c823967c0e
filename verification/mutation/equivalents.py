"""Mutants that were judged equivalent, once: no input tells them from the source. Listed with the reason in equivalent.toml."""

import pathlib
import tomllib

import mutants
from rooms import ROOT

LIST = pathlib.Path(__file__).with_name("equivalent.toml")
KEYS = {"file", "line", "mutation", "reason"}


def read(path=LIST):
    """{(file, line, mutation): reason}; lines without their indentation."""
    with pathlib.Path(path).open("rb") as file:
        entries = tomllib.load(file).get("equivalent", [])
    judged = {}
    for number, entry in enumerate(entries, 1):
        if set(entry) != KEYS or not all(isinstance(v, str) and v for v in entry.values()):
            raise ValueError(f"{path}: entry {number}: found the keys {', '.join(entry)}, expected text for each of {', '.join(sorted(KEYS))}")
        judged[entry["file"], entry["line"].strip(), entry["mutation"].strip()] = entry["reason"]
    return judged


def key(mutant):
    return mutant.file, mutant.before.strip(), mutant.after.strip()


def stale(judged, root=ROOT):
    """What is wrong with the list: its file, its line or its mutation is gone."""
    problems, made = [], {}
    for file, line, mutation in judged:
        if not (root / file).is_file():
            problems.append(f"{file}: judged equivalent, but there is no such file")
            continue
        if file not in made:
            made[file] = {key(m)[1:] for m in mutants.of_source(file, (root / file).read_text(encoding="utf-8"))}
        if line not in {before for before, _ in made[file]}:
            problems.append(f"{file}: no line {line!r}, of which a mutant was judged equivalent")
        elif (line, mutation) not in made[file]:
            problems.append(f"{file}: no operator makes {mutation!r} of {line!r}")
    return problems
