#pragma once

/// @file One run of an experiment, and what a game gives back.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace murosimf {

struct RunSettings {
  std::filesystem::path scenario;
  std::vector<std::string> overrides;  ///< PATH=VALUE, as of `--set`; without the seed
  std::uint64_t seed = 1;
};

/// The overrides of a run with its seed.
std::vector<std::string> allOverrides(const RunSettings& run);

struct PlayedRun {
  nlohmann::ordered_json report;  ///< as in report.json
  std::string failure;            ///< why the report is not to be trusted, or missing; empty: all went well
  double cpu_seconds = 0;         ///< of all frames, all threads together
  bool stopped = false;           ///< the game was not played to its end, because the caller said so
};

/// Plays one run in this process. It is asked again and again whether to stop. What it throws is a failure too.
using PlayRun = std::function<PlayedRun(const RunSettings& run, const std::function<bool()>& stop)>;

}  // namespace murosimf
