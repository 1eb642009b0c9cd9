#pragma once

/// @file The process of a batch that plays.

#include "experiment/batch.h"
#include "experiment/batch_board.h"

namespace murosimf {

class BatchWorker {
 public:
  BatchWorker(const std::vector<BatchRun>& runs, const ResultStore& store, const PlayRun& play,
              const BatchSettings& settings, BatchBoard& board, int number)
      : runs_(runs), store_(store), play_(play), settings_(settings), board_(board), number_(number) {}

  /// Plays what is open, in the order of the list, until `stop`. @throws std::runtime_error where a result cannot be
  /// written
  void work(const std::function<bool()>& stop);

 private:
  void playRun(std::size_t run, const std::function<bool()>& stop);
  RunResult played(const BatchRun& run, const std::function<bool()>& stop, bool& stopped) const;
  void tell(const BatchRun& run, const RunResult& result) const;

  const std::vector<BatchRun>& runs_;
  const ResultStore& store_;
  const PlayRun& play_;
  const BatchSettings& settings_;
  BatchBoard& board_;
  int number_;
};

/// What a result makes of its run.
RunState stateOf(const RunResult& result);

}  // namespace murosimf
