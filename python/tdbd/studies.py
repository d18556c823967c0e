"""The commands check and converge."""

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from tdbd import _core, plots
from tdbd.cases import Case, of_kind
from tdbd.runs import Folder, Progress

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def check(case: Case | Folder) -> dict[str, Any]:
    """Estimates the resources of a run: builds bit and rock and tries the first steps. Writes nothing.

    For drilling: "triangles", "triangles_at_end", "memory_bytes", "disk_bytes", "seconds",
    "steps_tried", "warnings". For rotation: "cones", "energy" (J).
    """
    found = of_kind(case, "drilling", "rotation")
    return _core.check_rotation(found.checked) if found.kind == "rotation" else _core.check_drilling(found.checked)


@dataclass(frozen=True)
class Convergence:
    """The result of a convergence study."""

    data: dict[str, Any] = field(repr=False)  #: contents of convergence.json
    table: str = field(repr=False)  #: as printed in a terminal

    def __repr__(self) -> str:
        known = [f"{name} {order:.2f}" for name, order in self.orders.items() if order is not None]
        orders = ", ".join(known[:3]) + (", ..." if len(known) > 3 else "")
        found = f"orders {orders}" if known else "no order"
        return f"<tdbd.Convergence over {self.data['over']}, {len(self.sizes)} levels: {found}>"

    @property
    def sizes(self) -> np.ndarray:
        """(levels,) Values of the first refined quantity, SI."""
        return np.array([level["size"] for level in self.data["levels"]])

    @property
    def errors(self) -> dict[str, np.ndarray]:
        """Per variable: (levels - 1,) differences to the next level, or (levels,) errors against the reference, SI."""
        name = "errors" if self.data["against"] == "reference" else "differences"
        return {variable: np.array(found[name]) for variable, found in self.data["variables"].items()}

    @property
    def orders(self) -> dict[str, float | None]:
        """The observed order of every variable, or None; `data` then contains the reason."""
        return {variable: found["order"] for variable, found in self.data["variables"].items()}

    def plot(self) -> "Figure":
        """Plots the errors of all variables over the refined quantity."""
        return plots.errors(self.sizes, self.errors, self.data)


def converge(case: Case | Folder, over: str | Sequence[str], levels: int = 5, factor: float = 2.0, *,
             reference: Folder | None = None, folder: Folder | None = None, force: bool = False, threads: int = 1,
             progress: Progress | None = None) -> Convergence:
    """Refines quantities (`over`: "time.step") repeatedly by `factor` and computes observed orders: `tdbd converge`.

    `reference`: a result, folder or summary.json from which errors are computed. Without `folder`, nothing is written.
    """
    found = of_kind(case, "drilling", "rotation")
    keys = [over] if isinstance(over, str) else list(over)
    words = _core.StudyWords(keys, levels, factor, None if reference is None else os.fspath(reference))
    place = None if folder is None else os.fspath(folder)
    text, table = _core.converge(found.path, list(found.overrides), words, place, force, threads, progress)
    return Convergence(json.loads(text), table)
