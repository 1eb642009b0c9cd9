#include "murosimf/tailor_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "experiment/batch.h"
#include "experiment/run_identity.h"
#include "experiment/tailor_text.h"
#include "murosimf/commands.h"
#include "murosimf/play_run.h"
#include "murosimf/scene/scenario_reader.h"

namespace murosimf {

namespace {

constexpr int kTryAgain = 75;  ///< as of `murosimf sweep`

struct Interrupted {};

/// Plays what has no result yet, in processes of their own.
class CachedPlayer {
 public:
  CachedPlayer(const TailorArguments& arguments, std::filesystem::path folder)
      : arguments_(arguments), store_(std::move(folder)), identifier_(hashOfThisProgram()) {}

  std::vector<RunResult> play(const std::vector<RunSettings>& settings, const std::string& purpose) {
    std::vector<BatchRun> runs;
    for (const RunSettings& run : settings)
      runs.push_back({run, identifier_.identify(run), fmt::format("{}, seed {}", purpose, run.seed)});
    fmt::print(stderr, "{}: {} {}\n", purpose, runs.size(), runs.size() == 1 ? "run" : "runs");
    const int threads = arguments_.threads;
    const PlayRun one = [threads](const RunSettings& run, const auto& stop) { return playRun(run, threads, stop); };
    const BatchOutcome outcome = playBatch(runs, store_, one, {arguments_.workers, false, true, identifier_.program()});
    if (outcome.interrupted) throw Interrupted{};
    std::vector<RunResult> results;
    for (const BatchRun& run : runs) {
      std::optional<RunResult> result = store_.read(run.identity);
      if (!result) throw std::runtime_error(run.label + " has no result: another process plays it, or it was given up");
      results.push_back(std::move(*result));
    }
    return results;
  }

 private:
  const TailorArguments& arguments_;
  ResultStore store_;
  RunIdentifier identifier_;
};

void writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

/// The scenario with what was found, every value written out.
std::string tailoredScenario(const TailorArguments& arguments, const std::vector<std::string>& found) {
  std::vector<std::string> all = arguments.overrides;
  all.insert(all.end(), found.begin(), found.end());
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(arguments.scenario, all, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.text());
  return fmt::format("# {} at the level of detail that `murosimf tailor` found for {} within +-{}.\n\n{}",
                     arguments.scenario, arguments.metric, arguments.tolerance, writeScenario(*scene));
}

void writeFindings(const TailorArguments& arguments, const TailorQuestion& question, const std::vector<Detail>& details,
                   const TailorResult& result) {
  const std::filesystem::path folder = arguments.out;
  const std::string text = tailorText(question, details, result);
  writeText(folder / "tailor.md", text);
  writeText(folder / "tailor.json", tailorJson(question, details, result));
  writeText(folder / "tailored.toml", tailoredScenario(arguments, overridesOf(details, result.choices)));
  fmt::print("{}\nResults: tailor.md, tailor.json and the scenario tailored.toml in {}\n", text, folder.string());
}

int search(const TailorArguments& arguments, const std::vector<Detail>& details, const Metric& metric) {
  TailorSettings settings;
  settings.fixed = arguments.overrides;
  settings.seeds = arguments.seeds;
  settings.first_seed = static_cast<std::uint64_t>(arguments.first_seed);
  settings.test = {arguments.tolerance, arguments.confidence};
  CachedPlayer player(arguments, std::filesystem::path(arguments.out) / "runs");
  const auto play = [&](const auto& runs, const std::string& purpose) { return player.play(runs, purpose); };
  const TailorResult result = Tailor(arguments.scenario, details, metric, settings, play).run();
  writeFindings(arguments, {arguments.scenario, metric.text(), settings.test, settings.seeds}, details, result);
  return result.check.equivalent ? 0 : kFault;
}

}  // namespace

CLI::App* addTailor(CLI::App& app, TailorArguments& arguments) {
  CLI::App* command = app.add_subcommand("tailor", "find the cheapest level of detail that leaves a metric unchanged");
  command->add_option("scenario", arguments.scenario, "scenario file (.toml)")->required();
  command->add_option("--metric", arguments.metric, "path in report.json, as of sweeps (docs/sweeps.md)")->required();
  command->add_option("--tolerance", arguments.tolerance, "largest change of the metric that is allowed")
      ->required()
      ->check(CLI::Validator(
          [](const std::string& text) {
            double value = 0;
            return CLI::detail::lexical_cast(text, value) && value > 0 ? "" : text + " is no number above 0";
          },
          "NUMBER > 0"));
  command->add_option("--confidence", arguments.confidence, "that the change is below the tolerance, on each side")
      ->check(CLI::Range(0.6, 0.9999));
  command->add_option("--seeds", arguments.seeds, "games a choice; as many check the result")
      ->check(CLI::Range(2, 100000));
  command->add_option("--first-seed", arguments.first_seed, "seeds count from here")->check(CLI::NonNegativeNumber);
  command->add_option("--set", arguments.overrides, "PATH=VALUE: change the scenario; what is set here is no detail")
      ->allow_extra_args(false);
  command->add_option("--only", arguments.only, "robots.red.1: choose details of this alone, leave all else as it is")
      ->allow_extra_args(false);
  command->add_option("--workers", arguments.workers, "processes that play at once")->check(CLI::Range(1, 1024));
  command->add_option("--threads", arguments.threads, "threads of one game; 0: all")->check(CLI::Range(0, 1024));
  command->add_option("--out", arguments.out, "folder of the results");
  return command;
}

int tailor(const TailorArguments& arguments) {
  Diagnostics diagnostics;
  std::string problem;
  const std::optional<Metric> metric = Metric::parse(arguments.metric, problem);
  if (!metric) diagnostics.error({"--metric", 0, 0}, problem);
  const std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  const std::vector<Detail> details =
      scene ? detailsOf(*scene, arguments.overrides, arguments.only, diagnostics) : std::vector<Detail>{};
  if (scene && *scene->simulation.pace > 0)
    diagnostics.error(scene->simulation.pace.where, "pace is given, expected 0: results must not depend on a machine");
  if (scene && details.empty()) diagnostics.error({arguments.scenario, 0, 0}, "there is no detail to choose from");
  fmt::print(stderr, "{}", diagnostics.text());
  if (diagnostics.hasErrors()) return kWrongInput;
  try {
    return search(arguments, details, *metric);
  } catch (const Interrupted&) {
    fmt::print(stderr, "interrupted; the same command goes on from here\n");
    return kTryAgain;
  } catch (const std::runtime_error& fault) {
    fmt::print(stderr, "error: {}\n", fault.what());
    return kWrongInput;
  }
}

}  // namespace murosimf
