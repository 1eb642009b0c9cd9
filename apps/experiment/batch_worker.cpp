#include "experiment/batch_worker.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>

namespace murosimf {

namespace {

double wallClock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A result found on the disk after all, written by another machine since the batch began.
bool isSettledBy(const RunResult& result, const BatchSettings& settings) {
  return result.failure.empty() || !settings.retry_failed;
}

}  // namespace

RunState stateOf(const RunResult& result) { return result.failure.empty() ? RunState::kDone : RunState::kFailed; }

void BatchWorker::work(const std::function<bool()>& stop) {
  for (std::size_t run = 0; run < runs_.size() && !stop(); ++run) {
    if (board_.state(run) == RunState::kOpen) playRun(run, stop);
  }
}

void BatchWorker::playRun(std::size_t run, const std::function<bool()>& stop) {
  const std::unique_ptr<RunClaim> claim = store_.claim(runs_[run].identity);
  if (claim == nullptr || board_.state(run) != RunState::kOpen) return;
  board_.setPlaying(number_, static_cast<int>(run));
  std::optional<RunResult> result = store_.read(runs_[run].identity);
  bool stopped = false;
  const bool fresh = !result || !isSettledBy(*result, settings_);
  if (fresh) {
    result = played(runs_[run], stop, stopped);
    if (!stopped) store_.write(runs_[run].identity, *result, *claim);
  }
  if (!stopped) board_.settle(run, stateOf(*result));
  if (!stopped && fresh && !settings_.quiet) tell(runs_[run], *result);
  board_.setPlaying(number_, -1);
}

RunResult BatchWorker::played(const BatchRun& run, const std::function<bool()>& stop, bool& stopped) const {
  RunResult result;
  result.run = run.settings;
  result.program = settings_.program;
  const double start = wallClock();
  try {
    PlayedRun game = play_(run.settings, stop);
    stopped = game.stopped;
    result.failure = game.failure;
    result.cpu_seconds = game.cpu_seconds;
    result.report = withoutClocks(std::move(game.report));
  } catch (const std::exception& fault) {
    result.failure = fault.what();
  }
  result.wall_seconds = wallClock() - start;
  return result;
}

void BatchWorker::tell(const BatchRun& run, const RunResult& result) const {
  const std::string end =
      result.failure.empty() ? fmt::format("{:.1f} s", result.wall_seconds) : fmt::format("failed: {}", result.failure);
  fmt::print(stderr, "[{}/{}] {}: {}\n", board_.settled(), board_.size(), run.label, end);
}

}  // namespace murosimf
