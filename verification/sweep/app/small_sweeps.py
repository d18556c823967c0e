"""Designs that take seconds, and checks of the files that sweeps write."""

import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[3]


def drilling(sampling, samples, revolutions, rakes):
    """Bit B on coarse rock: sampled rates of penetration at each of these back rakes, in degrees."""
    levels = ", ".join(f'"{rake} deg"' for rake in rakes)
    return f"""[sweep]
case = "{ROOT}/cases/bit-b-6000psi.toml"
figures = ["wob_mean_n", "removed_volume_m3"]
sampling = "{sampling}"
samples = {samples}
[set]
rock.edge_length = "6 mm"
time.revolutions = {revolutions}
output.means_from = "0.01 s"
[[factors]]
key = "motion.rate_of_penetration"
from = "5 m/h"
to = "20 m/h"
[[factors]]
key = "bit.set.adjust.back_rake"
values = [{levels}]
"""


def tops(duration, *factors, title="", figures=("energy_drift_max", "steps"), goals=()):
    """Slow tops: each factor is its key and the lines that follow."""
    text = f'title = "{title}"\n' if title else ""
    text += f"""[sweep]
case = "{ROOT}/cases/slow-top.toml"
command = "rotate"
figures = {list(figures)}
[set]
time.duration = {duration}
"""
    text += "".join(f'[[factors]]\nkey = "{key}"\n{lines}\n' for key, lines in factors)
    return text + "".join(f'[[goals]]\nfigure = "{goal}"\n' for goal in goals)


def keys_in(points):
    """The keys of all whole lines of the journals below."""
    lines = [line for file in sorted(points.glob("*/points.jsonl")) for line in file.read_bytes().split(b"\n")[:-1]]
    return [json.loads(line[17:])["key"] for line in lines]


def assert_same_tables(folder, one, other):
    for kind in (".nc", ".csv"):
        assert (folder / f"{one}{kind}").read_bytes() == (folder / f"{other}{kind}").read_bytes(), kind
