#include "experiment/sweep_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "experiment/content_hash.h"
#include "experiment/plan_reader.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {

namespace {

namespace fs = std::filesystem;

/// A mistake in a case is the plan's: `--set PATH=VALUE` becomes the place in the plan where it stands.
void tellAtPlan(const Diagnostics& found, const SweepCase& one, Diagnostics& diagnostics) {
  for (const Diagnostic& d : found.all()) {
    SourceLocation where = d.where;
    std::string message = d.message;
    for (const Located<std::string>& change : one.changes) {
      if (where.file != "--set " + printable(*change)) continue;
      where = change.where;
      message = fmt::format("{} ({})", message, printable(*change));
      break;
    }
    if (d.severity == Diagnostic::Severity::kError)
      diagnostics.error(where, message);
    else
      diagnostics.warning(where, message);
  }
}

std::vector<std::string> texts(const SweepCase& one) {
  std::vector<std::string> out;
  for (const Located<std::string>& change : one.changes) out.push_back(*change);
  return out;
}

void checkCases(const SweepPlan& plan, Diagnostics& diagnostics) {
  std::set<std::string> told;
  for (const SweepCase& one : plan.cases) {
    Diagnostics found;
    const std::optional<Scene> scene = readScenario(plan.scenario, texts(one), found);
    if (!told.insert(found.text()).second) continue;
    tellAtPlan(found, one, diagnostics);
    if (scene && *scene->simulation.pace > 0) {
      diagnostics.error(scene->simulation.pace.where,
                        fmt::format("pace is {}, expected 0: results must not depend on how fast a machine is",
                                    *scene->simulation.pace));
    }
  }
}

}  // namespace

std::string SweepCase::name() const { return labels.empty() ? "all" : fmt::format("{}", fmt::join(labels, ", ")); }

std::optional<SweepPlan> readSweepPlanText(std::string_view text, const fs::path& file, Diagnostics& diagnostics) {
  const int errors_before = diagnostics.errorCount();
  const std::optional<TextNode> tree = parseToml(text, file.string(), diagnostics);
  if (!tree) return std::nullopt;
  SweepPlan plan = PlanReader(*tree, file, diagnostics).read();
  if (diagnostics.errorCount() == errors_before) checkCases(plan, diagnostics);
  if (diagnostics.errorCount() > errors_before) return std::nullopt;
  return plan;
}

std::optional<SweepPlan> readSweepPlan(const fs::path& file, Diagnostics& diagnostics) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) {
    diagnostics.error({file.string(), 0, 0},
                      fmt::format("{}, expected the plan of a sweep (TOML)",
                                  fs::exists(file, failed) ? "this is no file" : "there is no such file"));
    return std::nullopt;
  }
  return readSweepPlanText(readWholeFile(file), file, diagnostics);
}

std::vector<BatchRun> runsOf(const SweepPlan& plan, RunIdentifier& identifier) {
  std::vector<BatchRun> runs;
  for (const SweepCase& one : plan.cases) {
    for (const std::uint64_t seed : plan.seeds) {
      BatchRun& run = runs.emplace_back();
      run.settings = {plan.scenario, texts(one), seed};
      run.identity = identifier.identify(run.settings);
      run.label = fmt::format("{}, seed {}", one.name(), seed);
    }
  }
  return runs;
}

}  // namespace murosimf
