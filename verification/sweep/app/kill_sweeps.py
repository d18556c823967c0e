"""Kills sweeps at random moments and resumes them: nothing is lost or computed twice, and the table is bitwise identical to that of an
uninterrupted sweep. kill_sweeps.py TDBD FOLDER [KILLS] [SEED]"""

import pathlib
import random
import shutil
import subprocess
import sys
import time

from small_sweeps import assert_same_tables, drilling, keys_in

DESIGN = drilling("latin-hypercube", 12, 0.2, [0, 5])


def main(tdbd, folder, kills=12, seed=2007):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    design = folder / "design.toml"
    design.write_text(DESIGN)
    draw = random.Random(seed)
    begun = time.monotonic()
    subprocess.run([tdbd, "sweep", design, "-o", folder / "whole.nc", "--quiet", "--threads", "2"], check=True)
    whole = time.monotonic() - begun
    killed = rounds = 0
    while killed < kills:
        rounds += 1
        done = 0
        shutil.rmtree(folder / "killed.points", ignore_errors=True)
        (folder / "killed.nc").unlink(missing_ok=True)
        while not (folder / "killed.nc").exists():
            words = [tdbd, "sweep", design, "-o", folder / "killed.nc", "--quiet", "--threads", str(draw.choice([1, 2]))]
            process = subprocess.Popen(words)
            try:
                code = process.wait(timeout=draw.uniform(0.0, 0.6 * whole) if killed < kills else None)
                assert code == 0, (words, code)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                killed += 1
            keys = keys_in(folder / "killed.points")
            assert len(keys) == len(set(keys)), "a point was done twice"
            assert len(keys) >= done, "a point was lost"
            done = len(keys)
        assert done == 24
        assert_same_tables(folder, "killed", "whole")
    print(f"kill_sweeps: {killed} kills, {rounds} sweeps, each with the bytes of one that was left alone")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]), *map(int, sys.argv[3:]))
