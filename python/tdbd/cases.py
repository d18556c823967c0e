"""Cases: files with overrides that are read and checked."""

import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from tdbd import _core
from tdbd.arguments import assignments
from tdbd.errors import CaseWarning, in_python_words

_READ = {
    "drilling": _core.read_drilling,
    "rotation": _core.read_rotation,
    "calibration": _core.read_calibration,
    "laboratory": _core.read_laboratory,
}


@dataclass(frozen=True)
class Case:
    """A checked case. Returned by `tdbd.case`."""

    kind: str  #: "drilling", "rotation", "calibration" or "laboratory"
    path: str
    overrides: tuple[str, ...]  #: "rock.edge_length=2 mm", as in --set
    checked: Any = field(repr=False)  #: the case in the compiled module

    def __repr__(self) -> str:
        changes = "".join(f", {change}" for change in self.overrides)
        return f"<tdbd.Case of {self.title}, {self.kind}: {self.path}{changes}>"

    @property
    def resolved(self) -> str:
        """The case as TOML with all defaults, in SI. It is itself a case that gives the same result."""
        return self.checked.resolved

    @property
    def title(self) -> str:
        """Name of the bit or title of the case; the kind if it has none."""
        return getattr(self.checked, "title", "") or f"a {self.kind}"

    @property
    def hash(self) -> str:
        """Hash of the resolved values and the contents of all files: "case_hash" of a summary."""
        return self.checked.hash

    @property
    def quantities(self) -> dict[str, float]:
        """All quantities with a single value of a drilling or rotation case, by dotted key, in SI."""
        return dict(self.checked.quantities)

    @property
    def steps(self) -> int:
        """Number of steps of a drilling or rotation case, from the beginning to the end of the motion."""
        return self.checked.steps

    @property
    def parts(self) -> list[str]:
        """Names of the parts of the drilling bit, in the order of arrays by part."""
        return list(self.checked.parts)

    def replace(self, set: Mapping[str, Any] | None = None, **keys: Any) -> "Case":
        """Returns the same file with further overrides, which take precedence over earlier ones."""
        return _read(self.path, [*self.overrides, *assignments(set, keys)])

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles the path and overrides, so that another process reads the file again."""
        return _read, (self.path, list(self.overrides))


def _read(path: str, overrides: list[str]) -> Case:
    kind = _core.kind_of(path, overrides)
    if kind == "unknown":  # the reader of a drilling case reports what is missing
        kind = "drilling"
    else:
        _core.require_kind(path, overrides, list(_READ))
    checked = _READ[kind](path, overrides)
    for text in getattr(checked, "warnings", ()):
        warnings.warn(in_python_words(text), CaseWarning, stacklevel=3)
    return Case(kind, path, tuple(overrides), checked)


def case(path: str | os.PathLike[str], set: Mapping[str, Any] | None = None, **keys: Any) -> Case:
    """Reads and checks a case of any kind: drilling, rotation, calibration or laboratory.

    Overrides are keywords with `__` for the dot (`rock__edge_length="2 mm"`), or a dictionary
    (`set={"rock.edge_length": "2 mm"}`). Keywords take precedence. Texts are written as for
    `--set`; numbers are in SI. Raises CaseError that lists every mistake.
    """
    name = os.fsdecode(path)
    if "\0" in name:
        raise ValueError(f"path: found {name!r} with a zero byte, expected a file's name")
    return _read(name, assignments(set, keys))


def of_kind(given: "Case | str | os.PathLike[str]", *kinds: str) -> Case:
    """Returns the case, or reads it from a path. Raises CaseError if it is of another kind."""
    found = given if isinstance(given, Case) else case(given)
    if found.kind not in kinds:
        _core.require_kind(found.path, list(found.overrides), list(kinds))
        raise TypeError(f"found a case of kind {found.kind}, expected {' or '.join(kinds)}")
    return found
