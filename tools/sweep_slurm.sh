#!/bin/sh
# Plays a sweep as an array of Slurm jobs, each with its part of the runs (docs/sweeps.md):
#   sbatch --array=0-7 tools/sweep_slurm.sh scenarios/sweeps/short_games.toml
# Further options of sbatch as ever: --time, --partition, --cpus-per-task (that many games at once in each job).
# The plan's folder of results must be one that all machines share. Jobs can be cancelled, killed and submitted again at
# any time: what has a result is not played again.
#SBATCH --job-name=murosimf-sweep
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=sweep-%A_%a.log
exec "${MUROSIMF:-build/release/murosimf}" sweep run "$@" --workers "${SLURM_CPUS_PER_TASK:-1}"
