#pragma once

/// @file A robot's last steps, kept for the day on which its state turns out to be no number.
///
/// Single precision: 65 KB a robot of 21 joints, kept by the state guard and written by block_record.h.

#include <string>
#include <vector>

#include "murosimf/linking/linked_world.h"
#include "murosimf/simulation/block_record.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class StepHistory {
 public:
  static constexpr int kSteps = 200;

  StepHistory(LinkedWorld& linked, ObjectId robot);

  /// Numbers of one step.
  std::size_t width() const { return width_; }
  /// Where steps are kept: the first one there, at a multiple of 16 bytes, the next ones `stride` numbers apart, kSteps
  /// of them. Before nextRow().
  void keepAt(float* first, std::size_t stride) { first_ = first, stride_ = stride; }
  /// Whether a step of this phase ends with this frame.
  bool moved(Phase phase, long frame) const { return base_.phase() == phase && frame % base_.period() == 0; }
  /// Where the state of the moment is to be written, a row of BlockRecord.
  float* nextRow() { return slot(count_++); }
  void clear() { count_ = 0; }

  /// One step as it was kept.
  struct Step {
    double time = 0;  ///< at its end [s]
    Pose X_WB;
    SpatialMotion<double> V_WB;  ///< in the base's axes; zero where the motion has none
    std::vector<double> q, dq, command;
  };
  int size() const { return static_cast<int>(count_ < kSteps ? count_ : kSteps); }
  /// The oldest one has number 0.
  Step step(int number) const;
  /// What is wrong with the state of the moment: "joint_velocity of robots.red.2.left_knee is nan".
  std::string fault(const World& world) const;

 private:
  float* slot(long step) const { return first_ + static_cast<std::size_t>(step % kSteps) * stride_; }

  ObjectId robot_;
  Handle<Pose> base_;
  Handle<SpatialMotion<double>> velocity_;
  Handle<double> q_, dq_;
  std::size_t joints_ = 0, width_ = 0;
  float* first_ = nullptr;  // of a ring
  std::size_t stride_ = 0;
  long count_ = 0;
};

}  // namespace murosimf
