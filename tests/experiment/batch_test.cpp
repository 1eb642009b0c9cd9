#include "experiment/batch.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "experiment/folders.h"
#include "murosimf/math/random.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

std::vector<BatchRun> numberedRuns(int count) {
  std::vector<BatchRun> runs;
  for (int i = 0; i < count; ++i) {
    BatchRun& run = runs.emplace_back();
    run.settings.seed = static_cast<std::uint64_t>(i);
    run.identity = fmt::format("run{}", i);
    run.label = run.identity;
  }
  return runs;
}

/// A game that only says its seed.
PlayedRun playSeed(const RunSettings& run, const std::function<bool()>&) {
  return {{{"seed", run.seed}}, "", 0, false};
}

BatchSettings quietly(int workers) {
  BatchSettings settings;
  settings.workers = workers;
  settings.quiet = true;
  return settings;
}

void expectAllResults(const std::vector<BatchRun>& runs, const ResultStore& store) {
  for (const BatchRun& run : runs) {
    const std::optional<RunResult> result = store.read(run.identity);
    ASSERT_TRUE(result) << run.identity;
    EXPECT_EQ(result->report.at("seed"), run.settings.seed);
  }
}

/// How often runs were begun: a byte each.
class Tally {
 public:
  explicit Tally(fs::path file) : file_(std::move(file)) {}
  void add() const { std::ofstream(file_, std::ios::app) << 'x'; }
  std::size_t count() const { return readFile(file_).size(); }

 private:
  fs::path file_;
};

TEST(Batches, PlayEachRunOnceAndNeverAgain) {
  const fs::path folder = emptyFolder("batch");
  const ResultStore store(folder / "runs");
  const Tally begun(folder / "begun");
  const PlayRun play = [&](const RunSettings& run, const auto& stop) {
    begun.add();
    return playSeed(run, stop);
  };
  const std::vector<BatchRun> runs = numberedRuns(30);
  const BatchOutcome outcome = playBatch(runs, store, play, quietly(3));
  EXPECT_EQ(outcome.done, 30);
  EXPECT_EQ(outcome.failed + outcome.missing + outcome.restarts, 0);
  expectAllResults(runs, store);
  EXPECT_EQ(playBatch(runs, store, play, quietly(2)).done, 30);
  EXPECT_EQ(begun.count(), 30u);
}

TEST(Batches, TellFailuresAndCrashesAndGoOn) {
  const ResultStore store(emptyFolder("batch_failures"));
  const PlayRun play = [](const RunSettings& run, const auto& stop) -> PlayedRun {
    if (run.seed == 2) throw std::runtime_error("the ball is lost");
    if (run.seed == 4) std::abort();
    if (run.seed == 5) raise(SIGSEGV);
    if (run.seed == 6) return {{{"seed", 6}}, "a robot was frozen", 0, false};
    return playSeed(run, stop);
  };
  const BatchOutcome outcome = playBatch(numberedRuns(8), store, play, quietly(2));
  EXPECT_EQ(outcome.done, 4);
  EXPECT_EQ(outcome.failed, 4);
  EXPECT_EQ(outcome.missing, 0);
  EXPECT_GE(outcome.restarts, 2);  // another worker may meet the same crash before it is written down
  EXPECT_EQ(store.read("run2")->failure, "the ball is lost");
  EXPECT_EQ(store.read("run4")->failure, "the program crashed: Aborted");
  EXPECT_EQ(store.read("run5")->failure, "the program crashed: Segmentation fault");
  EXPECT_EQ(store.read("run6")->failure, "a robot was frozen");
}

TEST(Batches, PlayFailedRunsAgainOnlyWhenAsked) {
  const ResultStore store(emptyFolder("batch_retry"));
  const PlayRun fail = [](const RunSettings&, const auto&) -> PlayedRun { throw std::runtime_error("no luck"); };
  EXPECT_EQ(playBatch(numberedRuns(2), store, fail, quietly(1)).failed, 2);
  EXPECT_EQ(playBatch(numberedRuns(2), store, playSeed, quietly(1)).failed, 2);
  BatchSettings again = quietly(1);
  again.retry_failed = true;
  EXPECT_EQ(playBatch(numberedRuns(2), store, playSeed, again).done, 2);
}

TEST(Batches, LoseNoRunToWorkersThatAreKilled) {
  const fs::path folder = emptyFolder("batch_killed");
  const ResultStore store(folder / "runs");
  const Tally begun(folder / "begun");
  const PlayRun play = [&](const RunSettings& run, const auto& stop) {
    const std::size_t beginning = begun.count();
    begun.add();
    if (beginning % 3 == 0) raise(SIGKILL);
    return playSeed(run, stop);
  };
  const std::vector<BatchRun> runs = numberedRuns(12);
  const BatchOutcome outcome = playBatch(runs, store, play, quietly(2));
  EXPECT_EQ(outcome.done, 12);
  EXPECT_GE(outcome.restarts, 4);
  expectAllResults(runs, store);
}

TEST(Batches, GiveUpARunThatGetsItsWorkersKilled) {
  const ResultStore store(emptyFolder("batch_given_up"));
  const PlayRun play = [](const RunSettings& run, const auto& stop) {
    if (run.seed == 1) raise(SIGKILL);
    return playSeed(run, stop);
  };
  const BatchOutcome outcome = playBatch(numberedRuns(4), store, play, quietly(2));
  EXPECT_EQ(outcome.done, 3);
  EXPECT_EQ(outcome.missing, 1);
  EXPECT_GE(outcome.restarts, kMostKills);
  EXPECT_LE(outcome.restarts, kMostKills + 1) << "the other worker may just have begun it again";
  EXPECT_FALSE(store.read("run1"));
}

TEST(Batches, LeaveRunsToThoseWhoPlayThem) {
  const ResultStore store(emptyFolder("batch_others"));
  const std::unique_ptr<RunClaim> held = store.claim("run1");
  const BatchOutcome outcome = playBatch(numberedRuns(3), store, playSeed, quietly(1));
  EXPECT_EQ(outcome.done, 2);
  EXPECT_EQ(outcome.missing, 1);
}

TEST(Batches, EndAtASignalAndGoOnNextTime) {
  const ResultStore store(emptyFolder("batch_signal"));
  const pid_t parent = getpid();
  const PlayRun play = [&](const RunSettings& run, const auto& stop) -> PlayedRun {
    if (run.seed != 1) return playSeed(run, stop);
    kill(parent, SIGTERM);
    while (!stop()) usleep(1000);
    return {{}, "", 0, true};
  };
  const BatchOutcome outcome = playBatch(numberedRuns(3), store, play, quietly(1));
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.done, 1);
  EXPECT_EQ(outcome.missing, 2);
  EXPECT_EQ(playBatch(numberedRuns(3), store, playSeed, quietly(1)).done, 3);
}

TEST(Batches, TellWhenResultsCannotBeWritten) {
  const fs::path folder = emptyFolder("batch_disk");
  const ResultStore store(folder / "runs");
  const PlayRun play = [&](const RunSettings& run, const auto& stop) {
    fs::remove_all(folder);
    return playSeed(run, stop);
  };
  EXPECT_THROW(playBatch(numberedRuns(1), store, play, quietly(1)), std::runtime_error);
}

}  // namespace
}  // namespace murosimf::test
