"""Fingerprints of inputs, and stamps that store the fingerprints of the inputs of an output."""

import ast
import hashlib
import json
import tomllib
from pathlib import Path


class Stale(Exception):
    """An output is missing or was made from other inputs. The message names it and the remedy."""


def of_bytes(*parts):
    digest = hashlib.sha256()
    for part in parts:
        digest.update(len(part).to_bytes(8, "big") + part)
    return digest.hexdigest()


def of_value(value):
    return of_bytes(json.dumps(value, sort_keys=True).encode())


def of_file(path):
    return of_bytes(Path(path).read_bytes())


def strings(value):
    if isinstance(value, str):
        yield value
    elif isinstance(value, (dict, list)):
        for inner in value.values() if isinstance(value, dict) else value:
            yield from strings(inner)


def of_case(case):
    """Fingerprint of a case and of every file that it names relative to its folder."""
    case = Path(case)
    document = tomllib.loads(case.read_text(encoding="utf-8"))
    named = sorted({s for s in strings(document) if s and "\n" not in s and (case.parent / s).is_file()})
    return of_value([of_file(case)] + [[s, of_file(case.parent / s)] for s in named])


def figure_modules(script):
    """The names of the modules of figures/ that a script imports."""
    for node in ast.walk(ast.parse(script.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module == "figures":
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("figures."):
            yield node.module.split(".")[1]


def scripts_of(figures, script):
    """A script and all modules of figures/ that it uses, directly or indirectly."""
    found, to_read = set(), [script]
    while to_read:
        path = to_read.pop()
        if path not in found and path.is_file():
            found.add(path)
            to_read += [figures / f"{name}.py" for name in figure_modules(path)]
    return sorted(found)


def of_scripts(figures, *scripts):
    """Fingerprint of scripts and of all modules of figures/ that they use."""
    used = sorted({u for script in scripts for u in scripts_of(figures, script)})
    return of_value([[u.name, of_file(u)] for u in used])


def objects(build, program):
    """The object files of a program in a build folder: those of src, and for a twin or the comparison also those of reference."""
    folders = ["src"]
    if program == "tdbd-compare":
        folders.append("reference")
    elif "/" in program:
        folders.append(program.split("/")[0])
    return sorted(o for f in folders for o in (build / f).rglob("*.o") if "provenance" not in o.name)


def of_program(build, program):
    """Fingerprint of the machine code of a program, independent of the commit that it was built from.

    The executable contains the name of the commit, so it changes with every commit. Its object files do not, except the
    one with the provenance. Therefore the fingerprint is that of the other object files: a commit that changes no machine
    code causes no new runs. For a program without object files (a script) it is that of the file.
    """
    found = objects(Path(build), program)
    if not found:
        return of_file(Path(build) / program)
    return of_value([[str(o.relative_to(build)), of_file(o)] for o in found])


def write(path, value):
    """Whole or not at all."""
    partial = Path(f"{path}.partial")
    partial.parent.mkdir(parents=True, exist_ok=True)
    partial.write_text(json.dumps(value, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    partial.rename(path)


def read(path):
    """The stamp in a file, or an empty one."""
    try:
        return json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
