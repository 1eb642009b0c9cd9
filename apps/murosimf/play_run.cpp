#include "murosimf/play_run.h"

#include <fmt/format.h>

#include <ctime>
#include <stdexcept>

#include "murosimf/run.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {

namespace {

[[noreturn]] void refuse(const Diagnostics& diagnostics) {
  std::string text = diagnostics.text();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  throw std::runtime_error(text);
}

/// Of all threads of this process.
double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Frozen robots and programs that failed: the game went on, but not as the scenario says.
std::string failureOf(const nlohmann::ordered_json& report, bool frozen) {
  if (frozen)
    return fmt::format("a robot was frozen: {}", report.value("frozen_robots", nlohmann::ordered_json()).dump());
  if (!report.contains("control")) return "";
  const auto& faults = report.at("control").at("faults");
  return faults.empty() ? "" : fmt::format("control software failed: {}", faults.dump());
}

}  // namespace

PlayedRun playRun(const RunSettings& run, int threads, const std::function<bool()>& stop) {
  RunArguments arguments;
  arguments.report_only = true;
  arguments.scenario = run.scenario.string();
  arguments.overrides = {fmt::format("simulation.threads={}", threads)};
  for (const std::string& assignment : allOverrides(run)) arguments.overrides.push_back(assignment);
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  if (!scene) refuse(diagnostics);
  Run game(arguments, *scene, diagnostics);
  if (diagnostics.hasErrors()) refuse(diagnostics);
  PlayedRun played;
  const double before = processorSeconds();
  played.stopped = !game.play(stop);
  played.cpu_seconds = processorSeconds() - before;
  played.report = game.report();
  played.failure = failureOf(played.report, game.anyFrozen());
  return played;
}

}  // namespace murosimf
