"""A sweep in four shards under Snakemake: the bytes of a single process; nothing is run again. snakemake_sweep.py TDBD FOLDER;
ends with 77 where there is no Snakemake."""

import os
import pathlib
import shutil
import subprocess
import sys

from small_sweeps import ROOT, assert_same_tables, tops

DESIGN = tops(2000, ("time.step", "from = 0.25\nto = 2.0\ncount = 10"))


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
    assert_same_tables(folder, "shards", "single")
    print("snakemake_sweep: four shards, the bytes of a single process")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
