#!/usr/bin/env bash
# A sweep as an array of jobs on Slurm: each task computes its share of the points, and the last one to finish writes the table.
#
#     sbatch --array=1-8 examples/slurm-array.sh DESIGN.toml NAME.nc
#
# A task that is killed or runs out of time loses only its unfinished points: submit the array again, or that task alone
# (--array=5), to resume. NAME.nc must be on a file system that all nodes can access. Without Slurm, use
# `tdbd sweep DESIGN.toml -o NAME.nc --threads N`.
#SBATCH --job-name=tdbd-sweep
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --output=tdbd-sweep-%A_%a.log
set -euo pipefail
if [ $# -ne 2 ]; then
  echo "slurm-array.sh: found $# words, expected DESIGN.toml NAME.nc" >&2
  exit 2
fi
if [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
  echo "slurm-array.sh: found no array of Slurm's; submit with: sbatch --array=1-8 $0 $*" >&2
  echo "without Slurm: tdbd sweep $1 -o $2 --threads $(nproc)" >&2
  exit 2
fi
# The whole array counts, not the tasks that are submitted again: set TDBD_SHARDS to its size then.
shards=${TDBD_SHARDS:-$SLURM_ARRAY_TASK_COUNT}
exec "${TDBD:-tdbd}" sweep "$1" -o "$2" --shard "$SLURM_ARRAY_TASK_ID/$shards" --threads "${SLURM_CPUS_PER_TASK:-1}" --quiet
