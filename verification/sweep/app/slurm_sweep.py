"""256 points on Slurm in 8 tasks, one of them killed on its way and submitted again: the table has the bytes of a single
process, no point was done twice. slurm_sweep.py TDBD FOLDER; ends with 77 where there is no Slurm."""

import pathlib
import shutil
import subprocess
import sys

import slurm_cluster
from small_sweeps import ROOT, assert_same_tables, drilling, keys_in

DESIGN = drilling("sobol", 64, 0.4, [-3, 0, 3, 6])


def main(tdbd, folder):
    why = slurm_cluster.why_not()
    if why:
        print(f"slurm_sweep: skipped: {why}")
        sys.exit(77)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    design, table = folder / "design.toml", folder / "cluster.nc"
    design.write_text(DESIGN)
    with slurm_cluster.Cluster(folder / "slurm") as cluster:
        array = ["sbatch", "--parsable", f"--output={folder}/task-%a.log", f"--chdir={folder}",
                 f"--export=ALL,TDBD={tdbd},TDBD_SHARDS=8"]
        script = [ROOT / "examples" / "slurm-array.sh", design, table]
        job = cluster.run(*array, "--array=1-8", *script)
        first = folder / "cluster.points" / "1-of-8" / "points.jsonl"
        cluster.wait_for(lambda: first.exists() and first.read_bytes().count(b"\n") >= 2, "two points of the first task")
        cluster.run("scancel", "--signal=KILL", f"{job}_1")
        cluster.wait_for(lambda: not cluster.jobs(), "the end of all tasks", 300.0)
        done = len(keys_in(folder / "cluster.points"))
        assert 224 < done < 256, f"{done} points are done after a task was killed"
        assert not table.exists(), "a table without all points"
        cluster.run(*array, "--array=1", *script)
        cluster.wait_for(lambda: not cluster.jobs(), "the end of the task that was submitted again", 300.0)
    keys = keys_in(folder / "cluster.points")
    assert len(keys) == len(set(keys)) == 256, (len(keys), len(set(keys)))
    subprocess.run([tdbd, "sweep", design, "-o", folder / "single.nc", "--quiet", "--threads", "2"], check=True)
    assert_same_tables(folder, "cluster", "single")
    print(f"slurm_sweep: 256 points in 8 tasks, task 1 killed after {done - 224} of its points and submitted again: "
          "the bytes of a single process")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
