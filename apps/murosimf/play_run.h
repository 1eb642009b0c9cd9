#pragma once

/// @file Plays one run of an experiment in this process.

#include "experiment/run_settings.h"

namespace murosimf {

/// @param threads  as simulation.threads; where the run itself says nothing of them
/// @throws std::runtime_error with what is wrong in the run's scenario
PlayedRun playRun(const RunSettings& run, int threads, const std::function<bool()>& stop);

}  // namespace murosimf
