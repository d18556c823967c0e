"""The numbers of README.md, from the design that the study runs."""

import tomllib
from pathlib import Path

GIVEN = ["what the shares leave to 1 is"]


def stated():
    design = tomllib.loads((Path(__file__).parents[3] / "cases/sweeps/balance-bit-b.toml").read_text(encoding="utf-8"))
    yield "judges {:.0f} places, the {:.0f} that it likes", design["sweep"]["samples"], design["filter"]["keep"]
