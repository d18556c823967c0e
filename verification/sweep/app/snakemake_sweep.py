"""A sweep in four shards under Snakemake: the bytes of a single process; nothing is run again. snakemake_sweep.py TDBD FOLDER;
ends with 77 where there is no Snakemake."""

import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
DESIGN = f"""[sweep]
case = "{ROOT}/cases/slow-top.toml"
command = "rotate"
figures = ["energy_drift_max", "steps"]
[set]
time.duration = 2000
[[factors]]
key = "time.step"
from = 0.25
to = 2.0
count = 10
"""


def main(tdbd, folder):
    snakemake = shutil.which("snakemake")
    if snakemake is None:
        print("snakemake_sweep: skipped: snakemake is not installed (bash scripts/setup cluster)")
        sys.exit(77)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    design = folder / "design.toml"
    design.write_text(DESIGN)
    words = ["/usr/bin/python3", snakemake, "-s", ROOT / "examples" / "Snakefile", "--directory", folder, "--cores", "2", "--config",
             f"design={design}", f"table={folder}/shards.nc", "shards=4"]
    surroundings = {**os.environ, "TDBD": tdbd, "XDG_CACHE_HOME": str(folder / "cache")}
    for expected in ("5 of 5 steps", "Nothing to be done"):
        done = subprocess.run(words, env=surroundings, capture_output=True, text=True)
        assert done.returncode == 0 and expected in done.stdout + done.stderr, (expected, done.stdout, done.stderr)
    subprocess.run([tdbd, "sweep", design, "-o", folder / "single.nc", "--quiet"], check=True)
    for kind in (".nc", ".csv"):
        assert (folder / f"shards{kind}").read_bytes() == (folder / f"single{kind}").read_bytes(), kind
    print("snakemake_sweep: four shards, the bytes of a single process")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
