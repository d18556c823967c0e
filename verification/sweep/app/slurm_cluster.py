"""A Slurm of one node on the loopback device, for a test: munged, slurmctld and slurmd in a folder of their own."""

import os
import pathlib
import shutil
import socket
import subprocess
import time

NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "scancel", "squeue")
CONF = """ClusterName=tdbd
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmctldPort={port}
SlurmdPort={slurmd_port}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
KillWait=2
SchedulerParameters=defer,sched_min_interval=100000
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why there can be none here; empty: it can be."""
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    missing = [p for p in NEEDED if shutil.which(p) is None]
    if missing:
        return f"{', '.join(missing)} not installed (bash scripts/setup cluster)"
    return "" if os.geteuid() == 0 else "Slurm's daemons are started as root"


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Cluster:
    """with Cluster(folder) as c: c.run("sbatch", ...). All daemons are gone at the end."""

    def __init__(self, folder, cpus=2):
        self.folder, self.daemons = pathlib.Path(folder), []
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        host = socket.gethostname().split(".")[0]
        conf = self.folder / "slurm.conf"
        conf.write_text(CONF.format(host=host, folder=self.folder, port=free_port(), slurmd_port=free_port(),
                                    cpus=min(cpus, os.cpu_count())))
        self.environment = {**os.environ, "SLURM_CONF": str(conf)}
        self.host = host

    def start(self, *words):
        log = (self.folder / f"{words[0]}.out").open("w")
        self.daemons.append(subprocess.Popen(words, env=self.environment, stdout=log, stderr=log))

    def run(self, *words):
        done = subprocess.run([str(w) for w in words], env=self.environment, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{words}: {done.stdout}{done.stderr}")
        return done.stdout.strip()

    def __enter__(self):
        self.folder.chmod(0o755)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        at = {name: f"--{name}={self.folder}/munge.{name.split('-')[0]}" for name in ("key-file", "pid-file", "log-file", "seed-file")}
        self.start("munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket", *at.values())
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D", "-N", self.host)
        self.wait_for(lambda: "idle" in self.run("sinfo", "--noheader", "--format=%T"), "slurmd")
        return self

    def wait_for(self, condition, what, seconds=60.0):
        end = time.monotonic() + seconds
        while True:
            try:
                if condition():
                    return
            except RuntimeError:  # the controller does not answer yet
                pass
            if time.monotonic() > end:
                logs = "".join(f"--- {p.name}\n{p.read_text(errors='replace')[-2000:]}" for p in sorted(self.folder.glob("*.log")))
                raise TimeoutError(f"{what} after {seconds} s\n{logs}")
            time.sleep(0.1)

    def jobs(self):
        """States of the jobs that are not at their end."""
        return self.run("squeue", "--noheader", "--array", "--format=%T").split()

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(timeout=15)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
