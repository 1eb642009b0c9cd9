#pragma once

/// @file `murosimf sweep run | collect | status`: many runs, and the table of what came out. docs/sweeps.md

#include <CLI/CLI.hpp>
#include <string>

namespace murosimf {

struct SweepArguments {
  enum class Action { kRun, kCollect, kStatus };
  Action action = Action::kRun;
  std::string plan;
  std::string out;      ///< folder in the place of the plan's directory
  std::string shard;    ///< "INDEX/COUNT"; empty: by the environment
  std::string program;  ///< beginning of a program's hash; empty: this program
  int workers = 1, threads = 1;
  bool retry_failed = false;
};

/// Adds the subcommand with its own three.
CLI::App* addSweep(CLI::App& app, SweepArguments& arguments);
/// @return the exit code of the program: 0 all is done; 1 runs failed or are missing; 2 wrong input; 75 interrupted
int sweep(const SweepArguments& arguments);

}  // namespace murosimf
