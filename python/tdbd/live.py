"""Simulations that the caller advances step by step, without output files."""

import json
import os
from typing import Any

import numpy as np

from tdbd import _core
from tdbd.cases import Case, of_kind
from tdbd.surfaces import Surface


class Simulation(_core.Drilling):
    """A bit that drills, between two steps: the first step of `tdbd.run` to its last, in memory.

    `step(n)` makes n steps, fewer where the case ends, and returns how many. Ctrl-C raises KeyboardInterrupt between two
    steps; the simulation can continue. Python's lock is released meanwhile; one thread at a time works on a simulation.
    """

    def __init__(self, case: Case | str | os.PathLike[str], threads: int = 1) -> None:
        self.case = of_kind(case, "drilling")
        super().__init__(self.case.checked, threads)

    @property
    def rock(self) -> Surface:
        """The rock's surface now."""
        vertices, faces, _ = self.surface()
        return Surface(vertices, faces)

    @property
    def last_part(self) -> np.ndarray:
        """(n,) int32 For every vertex of `rock` the part that cut it last, an index into `case.parts`; -1: none."""
        return self.surface()[2]

    @property
    def summary(self) -> dict[str, Any]:
        """The figures so far: what summary.json would hold. Status "interrupted" until the case's last step is made."""
        return json.loads(self.summary_json())


class Rotation(_core.Rotating):
    """A body that rotates, with or without cones, that the caller advances step by step. `step(n)` is that of a Simulation."""

    def __init__(self, case: Case | str | os.PathLike[str]) -> None:
        self.case = of_kind(case, "rotation")
        super().__init__(self.case.checked)

    @property
    def summary(self) -> dict[str, Any]:
        """The figures so far: what summary.json would hold."""
        return json.loads(self.summary_json())
