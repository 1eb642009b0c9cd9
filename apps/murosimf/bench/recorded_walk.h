#pragma once

/// @file The joint angles of a walk: recorded once from the reference gait, without feedback, then replayed to any
/// number of robots, each at its own place of the stride. Replaying costs a look into a table.

#include <vector>

#include "player/walking_engine.h"

namespace murosimf {

class RecordedWalk {
 public:
  /// A robot that stands, begins to walk, and then goes on at this velocity.
  /// @param period  from one row to the next [s]
  /// @throws std::logic_error when the gait does not repeat after its stride
  RecordedWalk(const controllers::WalkCommand& velocity, double period);

  /// Angles to command in this step [rad]; before step 0 those of the robot that waits.
  const controllers::JointAngles& at(long step) const {
    if (step < 0) return rows_.front();
    const long rows = static_cast<long>(rows_.size());
    return rows_[static_cast<std::size_t>(step < rows ? step : begin_ + (step - begin_) % stride_)];
  }
  /// Steps of a stride: it repeats after so many.
  long stride() const { return stride_; }
  /// Steps after which a robot walks as fast as it is to.
  long begin() const { return begin_; }
  const controllers::WalkCommand& velocity() const { return velocity_; }

 private:
  controllers::WalkCommand velocity_;
  std::vector<controllers::JointAngles> rows_;  // the beginning, then one stride
  long begin_ = 0, stride_ = 0;
};

}  // namespace murosimf
