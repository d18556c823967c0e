"""The noise that the mesh of cutters makes (thesis 3.3 and ch. 6): bit B drills steadily with cutters meshed in several ways.

In its steady state a cutter removes the same volume in every step. What varies is noise, of the meshes of cutters and rock.
meshes.csv was put together from these rows at edges of 1.5 and 0.75 mm.
"""

import numpy as np
from study_tools import ROOT

BITS = ROOT / "cases/bits"
VARIANTS = [f"graded {n}" for n in (256, 128, 64, 32, 16)] + [f"uniform {e} mm" for e in ("0.5", "1", "2", "4")]
CASE = """[bit]
file = "bit.toml"
[rock]
shape = "conforming"
edge_length = "EDGE mm"
wall = "20 mm"
[motion]
rotary_speed = "120 rpm"
rate_of_penetration = "30 m/h"
[time]
step = "1 ms"
revolutions = 2
[output]
history_every = 1
"""


def write_bit(m, variant):
    kind, size = variant.split()[:2]
    mesh = f"rim_segments = {size}" if kind == "graded" else f'uniform_edge = "{size} mm"'
    head, _, tail = (BITS / "bit-b.toml").read_text(encoding="utf-8").partition("[mesh]")
    rest = tail[tail.index("["):] if "[" in tail else ""
    m.file("bit.toml", head.replace('"bit-b.csv"', f'"{BITS / "bit-b.csv"}"') + f'[mesh]\ngrading = "{kind}"\n{mesh}\n{rest}')


def volumes(m, edge):
    """Volume per step and cutter over the last revolution, m3."""
    history = m.run(m.case(CASE.replace("EDGE", edge))).history
    owner = [str(p).split("/")[0] for p in history["part_name"].values]
    cutters = sorted({o for o in owner if o.startswith("cutter-")}, key=lambda c: int(c[7:]))
    step = history["removed_volume_by_part"].values
    return np.stack([step[:, [o == c for o in owner]].sum(axis=1) for c in cutters], 1)[-500:]


def rim_and_facets(m, variant):
    m.output("tdbd", "bit", m.temporary / "bit.toml", "-o", m.temporary / "bit", "--force")
    table = m.output("tdbd", "mesh", m.temporary / "bit/bit.stl").splitlines()
    kind, size = variant.split()[:2]
    return int(size) if kind == "graded" else round(np.pi * 19 / float(size)), sum(int(r.split()[2]) for r in table if r.startswith("cutter-1/"))


def measure(m):
    """Prints, for each mesh: corners of the rim, error of the outline, facets, scatter of the volume a step (median of the busier
    half of the cutters), and the volume against that of the first mesh (median, worst)."""
    for edge in ("1.5", "0.75"):
        reference = None
        for variant in VARIANTS:
            write_bit(m, variant)
            volume = volumes(m, edge)
            mean = volume.mean(axis=0)
            reference = mean if reference is None else reference
            busy = reference > np.median(reference)
            bias = np.abs(mean / reference - 1)[busy]
            rim, facets = rim_and_facets(m, variant)
            print(f"rock {edge} mm, {variant}: rim {rim}, sagitta {9.5 * (1 - np.cos(np.pi / rim)):.4f} mm, facets {facets}, "
                  f"scatter {100 * np.median(volume.std(axis=0)[busy] / mean[busy]):.2f} %, bias {100 * np.median(bias):.2f} % "
                  f"({100 * bias.max():.2f} %)", flush=True)
