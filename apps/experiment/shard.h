#pragma once

/// @file Which part of an experiment a process plays: every count-th run, beginning with run number index.
///
/// Said by `--shard INDEX/COUNT`, or by those who start many processes:
/// * Slurm arrays: SLURM_ARRAY_TASK_ID, _COUNT, _MIN, _STEP
/// * tasks of a Slurm step (`srun`): SLURM_PROCID, SLURM_STEP_NUM_TASKS, where SLURM_STEP_ID is set: in the batch
/// script
///   itself, which is one process whatever --ntasks says, there is no step
/// * MPI: OMPI_COMM_WORLD_RANK, _SIZE (Open MPI), PMI_RANK, PMI_SIZE (MPICH and others); these before Slurm's steps
/// * Kubernetes, indexed jobs: JOB_COMPLETION_INDEX, and JOB_COMPLETIONS, which the job's file must set
/// An array whose elements have several tasks each is cut twice.

#include <functional>
#include <optional>
#include <string>

#include "murosimf/world/diagnostics.h"

namespace murosimf {

struct Shard {
  int index = 0, count = 1;
  std::string source;  ///< who said so; empty: nobody, this is all
  bool has(std::size_t run) const { return run % static_cast<std::size_t>(count) == static_cast<std::size_t>(index); }
};

/// "0/4", ..., "3/4". Nothing after an error.
std::optional<Shard> readShard(const std::string& text, Diagnostics& diagnostics);

/// The value of a variable of the environment, nullptr where it is not set.
using Environment = std::function<const char*(const char* name)>;

/// @return all of it where nothing is set, nothing after an error: a number without its count, or one out of range
std::optional<Shard> shardOf(const Environment& environment, Diagnostics& diagnostics);

}  // namespace murosimf
