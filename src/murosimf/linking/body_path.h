#pragma once

/// @file Where a robot's bodies are at any time of a step: on the straight path from its beginning to its end.

#include "murosimf/linking/linked_world.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// A robot's body poses as others see them, also between two updates of a motion that is slower than the frame.
/// A motion that obeys contacts makes its step behind the pair phase: to it, in a frame in which the step is yet to
/// come, bodies go on as they moved in the last one.
class BodyPath {
 public:
  BodyPath() = default;
  /// The robot must have body_pose; its bodies then stand still while nothing has computed them.
  BodyPath(LinkedWorld& linked, ObjectId robot)
      : pose_(linked.handle(robot, kBodyPose, subset::kBodies)),
        last_(linked.handle(robot, kBodyPoseLast, subset::kBodies)) {}

  bool valid() const { return pose_.valid(); }
  /// Share of the step that has passed at the beginning of a frame, in [0, 1).
  double shareAt(long frame) const { return static_cast<double>(frame % period()) / static_cast<double>(period()); }
  /// Same at its end, in (0, 1].
  double shareAfter(long frame) const {
    return static_cast<double>(frame % period() + 1) / static_cast<double>(period());
  }
  /// Same for the pair phase, which comes before motions that obey contacts.
  double contactShareAt(long frame) const { return shareAt(frame) + (isAhead(frame) ? 1.0 : 0.0); }
  double contactShareAfter(long frame) const { return shareAfter(frame) + (isAhead(frame) ? 1.0 : 0.0); }
  /// X_WB of the body on a row.
  Pose pose(int row, double share) const {
    return share == 1.0 ? pose_.get(row) : interpolate(last_.get(row), pose_.get(row), share);
  }
  /// p_WB alone, cheaper.
  Vector3 position(int row, double share) const {
    return interpolate(last_.get(row).translation, pose_.get(row).translation, share);
  }
  Pose last(int row) const { return last_.get(row); }
  /// Asks the memory for the base's pose at the end of the step.
  void fetch() const { pose_.values().fetch(1); }
  Pose end(int row) const { return pose_.get(row); }

 private:
  int period() const { return pose_.period(); }
  bool isAhead(long frame) const { return pose_.phase() == Phase::kAdvance && frame % period() == 0; }

  Handle<Pose> pose_, last_;
};

}  // namespace murosimf
