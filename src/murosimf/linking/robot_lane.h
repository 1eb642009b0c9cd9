#pragma once

/// @file One robot of a block, as a module sees it that steps robots one by one.

#include <type_traits>

#include "murosimf/linking/block_memory.h"
#include "murosimf/linking/handle.h"

namespace murosimf {

/// Where the values of one property of one subset stand. T is const for constants.
template <class T>
struct RobotValues {
  ColumnRef column;
  int objects = 0;
};

class RobotLane {
 public:
  RobotLane(const BlockMemory& block, int width, int lane) : block_(block), width_(width), lane_(lane) {}

  /// Value of the subset's object number `object`.
  template <class T>
  std::remove_const_t<T> get(const RobotValues<T>& values, int object = 0) const {
    return at(values).get(object);
  }
  template <class T>
  void set(const RobotValues<T>& values, const T& value, int object = 0) const {
    static_assert(!std::is_const_v<T>, "constants are constant");
    at(values).set(value, object);
  }

 private:
  template <class T>
  LaneValues<std::remove_const_t<T>> at(const RobotValues<T>& values) const {
    double* piece = block_.piece[static_cast<int>(values.column.memory)];
    return {piece + values.column.offset * width_ + lane_, width_};
  }

  const BlockMemory& block_;
  int width_, lane_;
};

}  // namespace murosimf
