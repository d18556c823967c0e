#!/usr/bin/env bash
# Runs a sweep as an array of 8 tasks on Slurm. Each task computes 1/8 of the points; the last task to finish writes NAME.nc.
#
#     sbatch --array=1-8 examples/slurm-array.sh DESIGN.toml NAME.nc
#
# If a task is killed or runs out of time, submit the same command again: finished points are not repeated. To submit one task
# alone, state the size of the whole array:
#
#     TDBD_SHARDS=8 sbatch --array=5 examples/slurm-array.sh DESIGN.toml NAME.nc
#
# NAME.nc must be on a file system that all nodes can access. TDBD is the program to run; default: tdbd.
# Without Slurm, use `tdbd sweep DESIGN.toml -o NAME.nc --threads N`.
#SBATCH --job-name=tdbd-sweep
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --output=tdbd-sweep-%A_%a.log
set -euo pipefail
if [ $# -ne 2 ]; then
  echo "slurm-array.sh: found $# arguments, expected DESIGN.toml NAME.nc" >&2
  exit 2
fi
if [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
  echo "slurm-array.sh: this is not a task of a Slurm array; submit it with: sbatch --array=1-8 $0 $*" >&2
  echo "without Slurm: tdbd sweep $1 -o $2 --threads $(nproc)" >&2
  exit 2
fi
# SLURM_ARRAY_TASK_COUNT is the number of submitted tasks: 1 for --array=5. TDBD_SHARDS then has the size of the whole array.
shards=${TDBD_SHARDS:-$SLURM_ARRAY_TASK_COUNT}
exec "${TDBD:-tdbd}" sweep "$1" -o "$2" --shard "$SLURM_ARRAY_TASK_ID/$shards" --threads "${SLURM_CPUS_PER_TASK:-1}" --quiet
