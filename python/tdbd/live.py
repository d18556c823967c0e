"""Simulations that the caller advances step by step, without output files."""

import json
import os
from typing import Any

import numpy as np

from tdbd import _core
from tdbd.cases import Case, of_kind
from tdbd.surfaces import Surface


def _refused(simulation: object) -> TypeError:
    name = type(simulation).__name__
    return TypeError(f"tdbd.{name}: a simulation between two steps cannot be copied, pickled or sent to another process; "
                     "return its `summary`, pickle its `case`, or use tdbd.run or tdbd.rotate, whose results can be pickled")


class Simulation(_core.Drilling):
    """A drilling bit between two steps, in memory. All steps together are those of `tdbd.run`.

    `step(n)` makes n steps, or fewer if the case ends, and returns their number. Ctrl-C raises
    KeyboardInterrupt between two steps; the simulation can continue. The interpreter lock is
    released during the steps; only one thread at a time may use a simulation.
    """

    def __init__(self, case: Case | str | os.PathLike[str], threads: int = 1) -> None:
        self.case = of_kind(case, "drilling")
        super().__init__(self.case.checked, threads)

    def __reduce__(self) -> tuple[Any, ...]:
        raise _refused(self)

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        raise _refused(self)

    def __repr__(self) -> str:
        return (f"<tdbd.Simulation of {self.case.title}: step {self.steps_done} of {self.case.steps}, "
                f"t = {self.time:.6g} s, {1e6 * self.removed_volume:.6g} cm3 removed>")

    @property
    def rock(self) -> Surface:
        """The current surface of the rock."""
        vertices, faces, _ = self.surface()
        return Surface(vertices, faces)

    @property
    def last_part(self) -> np.ndarray:
        """(n,) int32: for every vertex of `rock`, the part that last cut it as an index into `case.parts`; -1: none."""
        return self.surface()[2]

    @property
    def summary(self) -> dict[str, Any]:
        """The results so far, as in summary.json. The status is "interrupted" until the last step is made."""
        return json.loads(self.summary_json())


class Rotation(_core.Rotating):
    """A rotating body, with or without cones, that the caller advances step by step. `step(n)` as in Simulation."""

    def __init__(self, case: Case | str | os.PathLike[str]) -> None:
        self.case = of_kind(case, "rotation")
        super().__init__(self.case.checked)

    def __reduce__(self) -> tuple[Any, ...]:
        raise _refused(self)

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        raise _refused(self)

    def __repr__(self) -> str:
        return (f"<tdbd.Rotation of {self.case.title}: step {self.steps_done} of {self.case.steps}, "
                f"t = {self.time:.6g} s>")

    @property
    def summary(self) -> dict[str, Any]:
        """The results so far, as in summary.json."""
        return json.loads(self.summary_json())
