#pragma once

/// @file Stands in for oneTBB's task_arena in the build with the thread sanitizer, see task_group.h beside it.

#include <utility>

namespace oneapi::tbb {

class task_arena {
 public:
  static constexpr int automatic = -1;
  explicit task_arena(int = automatic) {}
  template <class Function>
  decltype(auto) execute(Function&& function) {
    return std::forward<Function>(function)();
  }
};

}  // namespace oneapi::tbb
