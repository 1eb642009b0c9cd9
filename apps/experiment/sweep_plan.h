#pragma once

/// @file What a sweep plays: cases (parameters of a scenario) x seeds. The format: docs/sweeps.md.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/batch.h"
#include "experiment/metric.h"
#include "experiment/run_identity.h"
#include "murosimf/scene/located.h"

namespace murosimf {

/// One combination of parameters.
struct SweepCase {
  std::vector<std::string> labels;            ///< one an axis, as tables show them
  std::vector<Located<std::string>> changes;  ///< PATH=VALUE in their order, and where the plan says so

  std::string name() const;  ///< labels joined; "all" without axes
};

struct SweepPlan {
  std::filesystem::path file, scenario;
  std::filesystem::path directory;  ///< of the results; relative to the working folder
  std::vector<std::string> axes;    ///< "case" where the plan has named cases, then the paths of its parameters
  std::vector<SweepCase> cases;     ///< the last axis changes fastest
  std::vector<std::uint64_t> seeds;
  std::vector<Located<Metric>> metrics;
  double confidence = 0.95;  ///< of the intervals

  std::filesystem::path runsFolder() const { return directory / "runs"; }
};

/// Reads the plan and, with the changes of every case, its scenario, so that whatever is wrong is told before the first
/// game. @return nothing after an error
std::optional<SweepPlan> readSweepPlan(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same of a text; `file` names it in messages, and the scenario is looked for from its folder.
std::optional<SweepPlan> readSweepPlanText(std::string_view text, const std::filesystem::path& file,
                                           Diagnostics& diagnostics);

/// Case by case, seed by seed. @throws std::runtime_error naming an input file that cannot be read
std::vector<BatchRun> runsOf(const SweepPlan& plan, RunIdentifier& identifier);

}  // namespace murosimf
