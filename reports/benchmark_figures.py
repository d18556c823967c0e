"""What benchmarks/measured.json holds, for the prose of studies and of benchmarks/README.md."""

import json
import sys
from pathlib import Path

BENCHMARKS = Path(__file__).resolve().parents[1] / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))
from goals import figures, find  # noqa: E402

sys.path.remove(str(BENCHMARKS))


def data():
    return json.loads((BENCHMARKS / "measured.json").read_text(encoding="utf-8"))


def measured(*path):
    """The figure at a path of keys as goals.json has them, "before" in front for the older commit; an error where nothing is."""
    of, path = (data()["before"], path[1:]) if path[0] == "before" else (data(), path)
    number = find(figures(of), path)
    if number is None:
        raise KeyError(f"benchmarks/measured.json has nothing at {' '.join(path)}")
    return number
