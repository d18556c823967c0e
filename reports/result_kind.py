"""The kind of a result that a user names, or a message that states what was found instead."""

import json
from pathlib import Path

EXPECTED = ("expected a result folder of tdbd run, rotate, string, converge, calibrate, curve or tdbd bit BIT -o FOLDER --report, "
            "or the table NAME.nc of tdbd sweep")
# The file that marks a kind of result, and the kind; the first file that exists decides.
MARKS = (("convergence.json", "convergence"), ("calibration.json", "calibration"), ("comparison.json", "models"),
         ("curve.csv", "curve"), ("summary.json", ""), ("analysis.json", "bit"))
COMMANDS = {"run": "run", "rotate": "rotation", "string": "string"}
NAMES = {"run": "a run (tdbd run)", "rotation": "a rotation (tdbd rotate)", "string": "a drill string (tdbd string)",
         "convergence": "a convergence study (tdbd converge)", "calibration": "a calibration (tdbd calibrate)",
         "models": "a comparison of models (tdbd-compare)", "bit": "the analysis of a bit (tdbd bit --report)",
         "sweep": "the table of a sweep (tdbd sweep)", "curve": "a curve of rate over weight (tdbd curve)"}


class NoResult(ValueError):
    """A path that contains no result, or one that a command cannot use; the message states found and expected."""


def read(path):
    """A JSON file of a result. Raises NoResult."""
    try:
        value = json.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise NoResult(f"{path}: found no readable file ({error.strerror}), expected one that tdbd writes") from error
    except ValueError as error:
        raise NoResult(f"{path}: found no valid JSON ({error}), expected a file that tdbd writes") from error
    if not isinstance(value, dict):
        raise NoResult(f"{path}: found no object, expected a file that tdbd writes")
    return value


def kind_of_file(path):
    if path.suffix == ".nc" and path.name not in ("history.nc", "string.nc"):
        return "sweep"
    if path.suffix == ".toml":
        raise NoResult(f"{path}: found an input file (TOML), {EXPECTED}")
    if path.parent.joinpath("summary.json").is_file():
        raise NoResult(f"{path}: found a file of a result, expected its folder: {path.parent}")
    raise NoResult(f"{path}: found a file, {EXPECTED}")


def without_summary(folder):
    """The message for a folder without a file that marks a complete result."""
    for name, found in (("failure.txt", "a run that failed (see failure.txt)"),
                        ("checkpoint.bin", f"a run that is not complete; to resume it: tdbd run --resume {folder}"),
                        ("bit.toml", "a bit without analysis.json; to write it: tdbd bit BIT -o FOLDER --report"),
                        ("case.toml", "a case without results")):
        if (folder / name).is_file():
            return f"{folder}: found {found}, {EXPECTED}"
    inside = sorted(f.name for f in folder.iterdir() if f.is_dir() and any((f / mark).is_file() for mark, _ in MARKS))
    where = f" (results are in its folders {', '.join(inside[:4])}{', ...' if len(inside) > 4 else ''})" if inside else ""
    return f"{folder}: found no result{where}, {EXPECTED}"


def kind_of(path):
    """run, rotation, string, convergence, calibration, models, curve, bit or sweep. Raises NoResult."""
    path = Path(path)
    if not path.exists():
        raise NoResult(f"{path}: found nothing, {EXPECTED}")
    if not path.is_dir():
        return kind_of_file(path)
    for name, kind in MARKS:
        if not (path / name).is_file():
            continue
        if kind:
            return kind
        command = read(path / name).get("command")
        if command in COMMANDS:
            return COMMANDS[command]
        raise NoResult(f"{path / name}: found the command {command!r}, expected run, rotate or string")
    raise NoResult(without_summary(path))


def demand(path, kinds):
    """The kind of a result if it is one of `kinds`. Raises NoResult."""
    kind = kind_of(path)
    if kind not in kinds:
        raise NoResult(f"{path}: found {NAMES[kind]}, expected {', or '.join(NAMES[k] for k in kinds)}")
    return kind
