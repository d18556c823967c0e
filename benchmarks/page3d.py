#!/usr/bin/python3
"""How long the 3-D page of a run takes, and how large it is: bit B, edges of 2.5 mm, 25 frames.

    benchmarks/page3d.py TDBD [--times 5]

Prints a line of JSON: median and largest wall time and processor time of the script as a user calls it, s, and bytes.
"""

import argparse
import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RUN = ("rock.edge_length=2.5 mm", "output.frames_every=60")


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def page(folder):
    """(wall, processor) s of one page."""
    began, before = time.monotonic(), processor_seconds()
    subprocess.run([sys.executable, "-B", ROOT / "reports/page3d.py", folder], check=True, stdout=subprocess.DEVNULL)
    return time.monotonic() - began, processor_seconds() - before


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", metavar="TDBD")
    parser.add_argument("--times", type=int, default=5)
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "run"
        settings = [word for s in RUN for word in ("--set", s)]
        subprocess.run([chosen.program, "run", ROOT / "cases/bit-b-steady.toml", "-o", folder, "--quiet", *settings], check=True)
        walls, processor = zip(*(page(folder) for _ in range(chosen.times)))
        size = (folder / "result.html").stat().st_size
    print(json.dumps({"wall_s": statistics.median(walls), "wall_most_s": max(walls), "processor_s": statistics.median(processor),
                      "processor_most_s": max(processor), "bytes": size}))


if __name__ == "__main__":
    main()
