#pragma once

/// @file `murosimf tailor`: the cheapest level of detail that leaves a metric unchanged. docs/tailor.md

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace murosimf {

struct TailorArguments {
  std::string scenario, metric, out = "out/tailor";
  std::vector<std::string> overrides;  ///< PATH=VALUE, of all runs
  std::vector<std::string> only;       ///< beginnings of paths of details; none: all
  double tolerance = 0, confidence = 0.95;
  int seeds = 20, first_seed = 1, workers = 1, threads = 1;
};

CLI::App* addTailor(CLI::App& app, TailorArguments& arguments);
/// @return the exit code of the program: 0 what was found holds on fresh seeds; 1 it does not; 2 wrong input;
/// 75 interrupted
int tailor(const TailorArguments& arguments);

}  // namespace murosimf
