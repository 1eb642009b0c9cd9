#pragma once

/// @file Where control software runs: on threads that are not the frame's.

#include <functional>
#include <memory>

namespace murosimf {

/// Runs task(robot) on some thread. The task must not throw, and is never launched twice at once for one robot.
class ProgramPool {
 public:
  using Task = std::function<void(int robot)>;
  ProgramPool() = default;
  ProgramPool(const ProgramPool&) = delete;
  ProgramPool& operator=(const ProgramPool&) = delete;
  virtual ~ProgramPool() = default;

  /// Returns at once.
  virtual void launch(int robot) = 0;
  /// Returns when no task runs.
  virtual void wait() = 0;
};

/// For the simulated clock: tasks share up to `threads` threads (0: all processors) with the one that waits for them.
std::unique_ptr<ProgramPool> makeSharedPool(int threads, ProgramPool::Task task);
/// For the paced clock: a thread for each robot, as each has a computer of its own. A program that sleeps or takes too
/// long delays no other, and needs no processor that the frame thread would have to give.
std::unique_ptr<ProgramPool> makeThreadPerRobot(int robots, ProgramPool::Task task);

}  // namespace murosimf
