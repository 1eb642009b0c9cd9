#pragma once

/// @file What the processes of a batch tell one another: a few numbers in memory that they share.

#include <atomic>
#include <cstddef>

namespace murosimf {

enum class RunState : int {
  kOpen,
  kDone,
  kFailed,   ///< has a result, which is a failure
  kGivenUp,  ///< has no result: every worker that played it was killed
};

/// Mapped before the processes part; outlives any of them. @throws std::runtime_error where there is no memory
class BatchBoard {
 public:
  BatchBoard(int workers, std::size_t runs);
  ~BatchBoard();
  BatchBoard(const BatchBoard&) = delete;
  BatchBoard& operator=(const BatchBoard&) = delete;

  std::size_t size() const { return runs_; }
  RunState state(std::size_t run) const { return static_cast<RunState>(states()[run].load()); }
  void settle(std::size_t run, RunState state) { states()[run] = static_cast<int>(state); }
  std::size_t count(RunState state) const;
  std::size_t settled() const { return runs_ - count(RunState::kOpen); }

  /// What a worker plays; -1: nothing.
  int playing(int worker) const { return numbers_[worker].load(); }
  void setPlaying(int worker, int run) { numbers_[worker] = run; }

 private:
  std::atomic<int>* states() const { return numbers_ + workers_; }

  int workers_;
  std::size_t runs_, bytes_;
  std::atomic<int>* numbers_;
};

}  // namespace murosimf
