#include "murosimf/sweep_command.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "experiment/shard.h"
#include "experiment/sweep_plot.h"
#include "experiment/sweep_table.h"
#include "murosimf/commands.h"
#include "murosimf/play_run.h"

namespace murosimf {

namespace {

namespace fs = std::filesystem;

constexpr int kTryAgain = 75;  ///< interrupted: EX_TEMPFAIL of sysexits.h, on which batch systems may start a job again

std::optional<SweepPlan> readPlan(const SweepArguments& arguments) {
  Diagnostics diagnostics;
  std::optional<SweepPlan> plan = readSweepPlan(arguments.plan, diagnostics);
  fmt::print(stderr, "{}", diagnostics.text());
  if (plan && !arguments.out.empty()) plan->directory = arguments.out;
  return plan;
}

std::optional<Shard> chooseShard(const SweepArguments& arguments) {
  Diagnostics diagnostics;
  const std::optional<Shard> shard =
      arguments.shard.empty() ? shardOf([](const char* name) -> const char* { return std::getenv(name); }, diagnostics)
                              : readShard(arguments.shard, diagnostics);
  fmt::print(stderr, "{}", diagnostics.text());
  return shard;
}

int runSweep(const SweepArguments& arguments) {
  const std::optional<SweepPlan> plan = readPlan(arguments);
  const std::optional<Shard> shard = chooseShard(arguments);
  if (!plan || !shard) return kWrongInput;
  RunIdentifier identifier(hashOfThisProgram());
  std::vector<BatchRun> mine;
  const std::vector<BatchRun> all = runsOf(*plan, identifier);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (shard->has(i)) mine.push_back(all[i]);
  const std::string part =
      shard->source.empty() ? ""
                            : fmt::format(", part {} of 0 to {} by {}", shard->index, shard->count - 1, shard->source);
  fmt::print(stderr, "{}: {} cases x {} seeds, {} runs to play{}\n", plan->file.string(), plan->cases.size(),
             plan->seeds.size(), mine.size(), part);
  const ResultStore store(plan->runsFolder());
  const int threads = arguments.threads;
  const BatchOutcome outcome = playBatch(
      mine, store, [threads](const RunSettings& run, const auto& stop) { return playRun(run, threads, stop); },
      {arguments.workers, arguments.retry_failed, false, identifier.program()});
  const std::string restarts = outcome.restarts > 0 ? fmt::format(", {} workers restarted", outcome.restarts) : "";
  fmt::print("{} runs done, {} failed, {} missing{}\nResults: {}\n", outcome.done, outcome.failed, outcome.missing,
             restarts, store.folder().string());
  if (outcome.interrupted) return kTryAgain;
  return outcome.failed + outcome.missing > 0 ? kFault : 0;
}

/// Programs other than this one that left results in the folder, and how many.
std::map<std::string, int> otherPrograms(const ResultStore& store, const std::string& own) {
  std::map<std::string, int> counts;
  for (const fs::directory_entry& entry : fs::directory_iterator(store.folder())) {
    if (entry.path().extension() != ".json") continue;
    const std::optional<RunResult> result = store.read(entry.path().stem().string());
    if (result && result->program != own) ++counts[result->program];
  }
  return counts;
}

/// SHA-256 of the program whose results are wanted: this one, or the one whose hash begins as said.
std::optional<std::string> chooseProgram(const SweepArguments& arguments, const ResultStore& store) {
  const std::string own = hashOfThisProgram();
  if (arguments.program.empty() || own.starts_with(arguments.program)) return own;
  std::vector<std::string> found;
  for (const auto& [program, count] : otherPrograms(store, own))
    if (program.starts_with(arguments.program)) found.push_back(program);
  if (found.size() == 1) return found.front();
  fmt::print(stderr, "error: --program {}: {} programs of the results in {} have a hash that begins so, expected 1\n",
             arguments.program, found.size(), store.folder().string());
  return std::nullopt;
}

void tellOtherPrograms(const ResultStore& store, const std::string& program) {
  for (const auto& [other, count] : otherPrograms(store, program))
    fmt::print(stderr, "note: {} results there are of another build of murosimf; --program {} takes those\n", count,
               other.substr(0, 12));
}

void writeText(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

int collectResults(const SweepArguments& arguments) {
  const std::optional<SweepPlan> plan = readPlan(arguments);
  if (!plan) return kWrongInput;
  const ResultStore store(plan->runsFolder());
  const std::optional<std::string> program = chooseProgram(arguments, store);
  if (!program) return kWrongInput;
  RunIdentifier identifier(*program);
  Diagnostics diagnostics;
  const SweepTable table = collectSweep(*plan, runsOf(*plan, identifier), store, diagnostics);
  fmt::print(stderr, "{}", diagnostics.text());
  if (diagnostics.hasErrors()) return kWrongInput;
  writeText(plan->directory / "table.csv", tableCsv(*plan, table));
  writeText(plan->directory / "runs.csv", runsCsv(*plan, table));
  writeText(plan->directory / "table.json", tableJson(*plan, table));
  writeText(plan->directory / "table.md", tableMarkdown(*plan, table));
  writeText(plan->directory / "plot.svg", sweepPlot(*plan, table));
  fmt::print("{}\nResults: table.md, table.csv, table.json, runs.csv and plot.svg in {}\n", tableMarkdown(*plan, table),
             plan->directory.string());
  if (table.missing() > 0) tellOtherPrograms(store, *program);
  return table.missing() + table.failed() > 0 ? kFault : 0;
}

int printStatus(const SweepArguments& arguments) {
  const std::optional<SweepPlan> plan = readPlan(arguments);
  if (!plan) return kWrongInput;
  const ResultStore store(plan->runsFolder());
  RunIdentifier identifier(hashOfThisProgram());
  Diagnostics metrics_are_for_collecting;
  const SweepTable table = collectSweep(*plan, runsOf(*plan, identifier), store, metrics_are_for_collecting);
  for (std::size_t c = 0; c < table.rows.size(); ++c) {
    const SweepRow& row = table.rows[c];
    fmt::print("{}: {} of {} runs done, {} failed, {} missing\n", plan->cases[c].name(), row.done, row.runs, row.failed,
               row.missing);
  }
  for (const SweepLine& line : table.lines)
    if (!line.failure.empty()) fmt::print("failed: seed {}: {}\n", line.seed, line.failure);
  if (table.missing() > 0) tellOtherPrograms(store, identifier.program());
  return table.missing() + table.failed() > 0 ? kFault : 0;
}

}  // namespace

int sweep(const SweepArguments& arguments) {
  switch (arguments.action) {
    case SweepArguments::Action::kRun:
      return runSweep(arguments);
    case SweepArguments::Action::kCollect:
      return collectResults(arguments);
    case SweepArguments::Action::kStatus:
      return printStatus(arguments);
  }
  return kFault;
}

}  // namespace murosimf
