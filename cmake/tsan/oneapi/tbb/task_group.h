#pragma once

/// @file Stands in for oneTBB's task_group in the build with the thread sanitizer: each task is a thread of its own.
///
/// The sanitizer sees only code that it compiled. What orders tasks inside libtbb.so stays hidden from it, and every
/// task would be reported as a race with whoever waits for it. Plain threads it understands; so what it reports here
/// are races of our tasks. The class has what our code uses of oneTBB's and no more.

#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace oneapi::tbb {

class task_group {
 public:
  task_group() = default;
  task_group(const task_group&) = delete;
  task_group& operator=(const task_group&) = delete;
  ~task_group() { wait(); }

  template <class Function>
  void run(Function&& function) {
    const std::lock_guard lock(mutex_);
    threads_.emplace_back(std::forward<Function>(function));
  }

  void wait() {
    std::vector<std::thread> running;
    {
      const std::lock_guard lock(mutex_);
      running.swap(threads_);
    }
    for (std::thread& thread : running) thread.join();
  }

 private:
  std::mutex mutex_;
  std::vector<std::thread> threads_;
};

}  // namespace oneapi::tbb
