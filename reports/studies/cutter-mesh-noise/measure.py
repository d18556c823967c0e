"""measure.py TDBD FOLDER [ROCK_EDGE_MM [VARIANT ...]]: the noise that the mesh of cutters makes (thesis: 3.3, ch. 6).

Bit B drills steadily with cutters meshed in several ways. In its steady state a cutter removes the
same volume in every step; what varies is noise, of the cutters' meshes and of the rock's. For each
meshing: corners of the rim, error of the outline (sagitta), facets of a cutter, the scatter of the
volume per step over the last revolution (rms over the mean, median over the cutters that cut most),
and the volume of each cutter against that of the first meshing (median, worst).
"""

import pathlib
import subprocess
import sys

import numpy
import xarray

BITS = pathlib.Path(__file__).resolve().parents[3] / "cases/bits"
VARIANTS = {  # name: lines of [mesh], corners of the rim of a 19 mm cutter
    "graded 256": 'grading = "graded"\nrim_segments = 256',
    "graded 128": 'grading = "graded"\nrim_segments = 128',
    "graded 64": 'grading = "graded"\nrim_segments = 64',
    "graded 32": 'grading = "graded"\nrim_segments = 32',
    "graded 16": 'grading = "graded"\nrim_segments = 16',
    "uniform 0.5 mm": 'grading = "uniform"\nuniform_edge = "0.5 mm"',
    "uniform 1 mm": 'grading = "uniform"\nuniform_edge = "1 mm"',
    "uniform 2 mm": 'grading = "uniform"\nuniform_edge = "2 mm"',
    "uniform 4 mm": 'grading = "uniform"\nuniform_edge = "4 mm"',
}
CASE = """[bit]
file = "{bit}"
[rock]
shape = "conforming"
edge_length = "{edge} mm"
wall = "20 mm"
[motion]
rotary_speed = "120 rpm"
rate_of_penetration = "30 m/h"
[time]
step = "1 ms"
revolutions = 2
"""


def bit_text(mesh):
    text = (BITS / "bit-b.toml").read_text(encoding="utf-8")
    head, _, tail = text.partition("[mesh]")
    rest = tail[tail.index("["):] if "[" in tail else ""
    return head.replace('"bit-b.csv"', f'"{BITS / "bit-b.csv"}"') + f"[mesh]\n{mesh}\n{rest}"


def drilled(program, folder, name, edge):
    """Volume per step and cutter over the last revolution, m3; and the bit's folder."""
    folder = folder / name.replace(" ", "-")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "bit.toml").write_text(bit_text(VARIANTS[name]), encoding="utf-8")
    (folder / "case.toml").write_text(CASE.format(bit="bit.toml", edge=edge), encoding="utf-8")
    subprocess.run([program, "run", folder / "case.toml", "-o", folder / "run", "--force",
                    "--quiet", "--set", "output.history_every=1"], check=True)
    with xarray.open_dataset(folder / "run/history.nc", decode_times=False) as history:
        step = history["removed_volume_by_part"].values
        owner = [str(p).split("/")[0] for p in history["part_name"].values]
    cutters = sorted({o for o in owner if o.startswith("cutter-")}, key=lambda c: int(c[7:]))
    by_cutter = numpy.stack([step[:, [o == c for o in owner]].sum(axis=1) for c in cutters], 1)
    return by_cutter[-500:]


def rim_and_facets(program, folder, name):
    out = folder / name.replace(" ", "-")
    subprocess.run([program, "bit", out / "bit.toml", "-o", out / "bit", "--force"], check=True,
                   stdout=subprocess.DEVNULL)
    table = subprocess.run([program, "mesh", out / "bit/bit.stl", "--unit", "1 m"], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    facets = sum(int(r.split()[2]) for r in table if r.startswith("cutter-1/"))
    kind, size = name.split()[:2]
    return int(size) if kind == "graded" else round(numpy.pi * 19 / float(size)), facets


def main(program, folder, edge="1.5", *names):
    folder = pathlib.Path(folder)
    reference = None
    print(f"rock edge {edge} mm\n{'cutters':>16} {'rim':>5} {'sagitta mm':>11} {'facets':>7} "
          f"{'scatter %':>10} {'bias % median':>14} {'worst':>7}")
    for name in names or VARIANTS:
        volume = drilled(program, folder, name, edge)
        mean = volume.mean(axis=0)
        reference = mean if reference is None else reference
        busy = reference > numpy.median(reference)
        scatter = numpy.median(volume.std(axis=0)[busy] / mean[busy])
        bias = numpy.abs(mean / reference - 1)[busy]
        rim, facets = rim_and_facets(program, folder, name)
        sagitta = 9.5 * (1 - numpy.cos(numpy.pi / rim))
        print(f"{name:>16} {rim:>5} {sagitta:>11.4f} {facets:>7} {100 * scatter:>10.2f} "
              f"{100 * numpy.median(bias):>14.2f} {100 * bias.max():>7.2f}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
