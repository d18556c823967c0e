"""Reads one study: its study.toml, its study.py, and its data by name, as expressions of study.toml use them.

study.toml has `tables`, `[let]`, `[measure]`, `[figure]` and `[stated]`, all optional; README.md explains them. Its
expressions are Python. They can use every CSV and JSON file of the folder by its name ("steps-before.csv" is `steps_before`),
the names of `[let]`, the functions of study.py, and `math`, `np`, `order`, `percent` and `measured`.
"""

import importlib.util
import json
import math
import sys
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import study_tools
from fingerprint import Stale
from study_tools import REPORTS, ROOT

FUNCTIONS = (study_tools.order, study_tools.percent, study_tools.measured, study_tools.benchmark_data)
KEYS = {"let", "measure", "tables", "figure", "stated"}


@dataclass
class Study:
    folder: Path
    plan: dict = field(default_factory=dict)  # study.toml
    module: object = None  # study.py
    names: dict = field(default_factory=dict)  # visible to expressions

    @property
    def name(self):
        return self.folder.name

    def function(self, name):
        """A function of study.py, or None."""
        return getattr(self.module, name, None)

    def value(self, expression, **more):
        """The value of an expression. Raises Stale with the expression if it fails."""
        try:
            return eval(expression, {**self.names, **more})  # noqa: S307
        except Exception as error:
            raise Stale(f"study {self.name}: {expression!r} failed: {type(error).__name__}: {error}") from error


def load_module(path):
    """The module at a path, which may import the modules of reports/. Raises Stale if the import fails."""
    spec = importlib.util.spec_from_file_location(f"study_of_{path.parent.name.replace('-', '_')}", path)
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(REPORTS))
    try:
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:
        raise Stale(f"{path}: {type(error).__name__}: {error}") from error
    finally:
        sys.path.remove(str(REPORTS))
    return module


def read_plan(folder):
    """The contents of study.toml, {} if there is none. Raises Stale for unknown tables."""
    file = folder / "study.toml"
    try:
        plan = tomllib.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    except tomllib.TOMLDecodeError as error:
        raise Stale(f"{file}: {error}") from error
    if unknown := sorted(set(plan) - KEYS):
        raise Stale(f"{file}: found {', '.join(unknown)}, expected {', '.join(sorted(KEYS))}")
    return plan


def name_of(file):
    return file.stem.replace("-", "_")


def data_of(folder):
    """{name: data} of all CSV and JSON files of a folder. If both have the same name, the CSV file is used."""
    found = {name_of(file): json.loads(file.read_text(encoding="utf-8")) for file in sorted(folder.glob("*.json"))}
    return found | {name_of(file): study_tools.read_rows(file) for file in sorted(folder.glob("*.csv"))}


def read_case(path):
    """A TOML file of the project, as a dictionary."""
    return tomllib.loads((ROOT / path).read_text(encoding="utf-8"))


def read_table(path):
    """A CSV file of the project."""
    return study_tools.read_rows(ROOT / path)


def load(folder):
    """The study in a folder."""
    folder = Path(folder).resolve()
    study = Study(folder, read_plan(folder))
    import numpy as np
    if (folder / "study.py").is_file():
        study.module = load_module(folder / "study.py")
        study.names.update({k: v for k, v in vars(study.module).items() if not k.startswith("_")})
    study.names.update(data_of(folder))
    study.names.update(math=math, np=np, read_case=read_case, read_table=read_table, **{f.__name__: f for f in FUNCTIONS})
    for name, expression in study.plan.get("let", {}).items():
        study.names[name] = study.value(expression)
    return study
