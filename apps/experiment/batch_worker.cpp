#include "experiment/batch_worker.h"

#include <fmt/format.h>

#include <ctime>
#include <exception>

namespace murosimf {

namespace {

double secondsOf(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A result found on the disk after all, written by another machine since the batch began.
bool isSettledBy(const RunResult& result, const BatchSettings& settings) {
  return result.failure.empty() || !settings.retry_failed;
}

}  // namespace

CostClock::CostClock() : cpu_start_(secondsOf(CLOCK_PROCESS_CPUTIME_ID)), wall_start_(secondsOf(CLOCK_MONOTONIC)) {}
double CostClock::cpuSeconds() const { return secondsOf(CLOCK_PROCESS_CPUTIME_ID) - cpu_start_; }
double CostClock::wallSeconds() const { return secondsOf(CLOCK_MONOTONIC) - wall_start_; }

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
  const CostClock cost;
  try {
    PlayedRun game = play_(run.settings, stop);
    stopped = game.stopped;
    result.failure = game.failure;
    result.report = withoutClocks(std::move(game.report));
  } catch (const std::exception& fault) {
    result.failure = fault.what();
  }
  result.cpu_seconds = cost.cpuSeconds();
  result.wall_seconds = cost.wallSeconds();
  return result;
}

void BatchWorker::tell(const BatchRun& run, const RunResult& result) const {
  const std::string end =
      result.failure.empty() ? fmt::format("{:.1f} s", result.wall_seconds) : fmt::format("failed: {}", result.failure);
  fmt::print(stderr, "[{}/{}] {}: {}\n", board_.settled(), board_.size(), run.label, end);
}

}  // namespace murosimf
