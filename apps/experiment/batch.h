#pragma once

/// @file Plays many runs in processes of their own, so that neither a crash nor a kill loses more than one game.
///
/// The calling process plays nothing: it starts workers, and starts another one where one died. A worker takes one run
/// after the other that has no result and that nobody else plays, here or on another machine with the same folder.
/// * A run whose game throws or says that it failed gets a result with that failure.
/// * A run during which the program crashed (SIGSEGV, SIGABRT, ...) likewise.
/// * A worker that was killed from outside leaves no trace: its run is begun again, up to kMostKills times.
/// SIGINT and SIGTERM end all games within a moment; what has no result yet is played next time.

#include <string>
#include <vector>

#include "experiment/result_store.h"
#include "experiment/run_settings.h"

namespace murosimf {

struct BatchRun {
  RunSettings settings;
  std::string identity;
  std::string label;  ///< for the line that tells its end
};

struct BatchSettings {
  int workers = 1;
  bool retry_failed = false;  ///< plays runs again whose result is a failure
  bool quiet = false;         ///< prints no line a run
  std::string program;        ///< SHA-256, kept with each result
};

struct BatchOutcome {
  int done = 0;     ///< runs with a result that is no failure, old ones among them
  int failed = 0;   ///< runs whose result is a failure
  int missing = 0;  ///< runs without a result: others play them, or the batch was interrupted, or gave them up
  int restarts = 0;
  bool interrupted = false;
};

/// So many that somebody who kills at random as often as a game ends makes no run be given up: 0.63^30 = 10^-6.
inline constexpr int kMostKills = 30;

/// Call in a process of one thread. Prints a line a run to stderr.
/// @throws std::runtime_error where results cannot be written or no process can be started
BatchOutcome playBatch(const std::vector<BatchRun>& runs, const ResultStore& store, const PlayRun& play,
                       const BatchSettings& settings);

}  // namespace murosimf
