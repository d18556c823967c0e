"""256 points on Slurm in 8 tasks, one of them killed on its way and submitted again: the table has the bytes of a single
process, no point was done twice. slurm_sweep.py TDBD FOLDER; ends with 77 where there is no Slurm."""

import json
import pathlib
import shutil
import subprocess
import sys

import slurm_cluster

ROOT = pathlib.Path(__file__).resolve().parents[3]
DESIGN = f"""[sweep]
case = "{ROOT}/cases/bit-b-6000psi.toml"
figures = ["wob_mean_n", "removed_volume_m3"]
sampling = "sobol"
samples = 64
[set]
rock.edge_length = "6 mm"
time.revolutions = 0.4
output.means_from = "0.01 s"
[[factors]]
key = "motion.rate_of_penetration"
from = "5 m/h"
to = "20 m/h"
[[factors]]
key = "bit.set.adjust.back_rake"
values = ["-3 deg", "0 deg", "3 deg", "6 deg"]
"""


def keys_in(points):
    lines = [line for file in sorted(points.glob("*/points.jsonl")) for line in file.read_bytes().split(b"\n")[:-1]]
    return [json.loads(line[17:])["key"] for line in lines]


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
    for kind in (".nc", ".csv"):
        assert (folder / f"cluster{kind}").read_bytes() == (folder / f"single{kind}").read_bytes(), kind
    print(f"slurm_sweep: 256 points in 8 tasks, task 1 killed after {done - 224} of its points and submitted again: "
          "the bytes of a single process")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
