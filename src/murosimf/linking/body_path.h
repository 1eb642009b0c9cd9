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
  /// The robot must have body_pose and shown_base; its bodies stand still while nothing has moved them.
  BodyPath(LinkedWorld& linked, ObjectId robot)
      : pose_(linked.handle(robot, kBodyPose, subset::kBodies)),
        last_(linked.handle(robot, kBodyPoseLast, subset::kBodies)),
        base_(linked.handle(robot, kShownBase)),
        base_last_(linked.handle(robot, kShownBaseLast)) {}

  bool valid() const { return base_.valid(); }
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
  Pose pose(int row, double share) const { return share == 1.0 ? end(row) : interpolate(last(row), end(row), share); }
  /// p_WB alone, cheaper.
  Vector3 position(int row, double share) const {
    return share == 1.0 ? end(row).translation : interpolate(last(row).translation, end(row).translation, share);
  }
  Pose last(int row) const { return row == 0 ? base_last_.get() : last_.get(row); }
  Pose end(int row) const { return row == 0 ? base_.get() : pose_.get(row); }
  /// Asks the memory for the base's poses.
  void fetch() const { base_.values().fetch(1), base_last_.values().fetch(1); }
  /// Asks it for the base's places alone.
  void fetchPlaces() const {
    base_.values().fetch(&Pose::translation);
    if (base_.period() > 1 || base_.phase() == Phase::kAdvance) base_last_.values().fetch(&Pose::translation);
  }

 private:
  int period() const { return base_.period(); }
  bool isAhead(long frame) const { return base_.phase() == Phase::kAdvance && frame % period() == 0; }

  Handle<Pose> pose_, last_;       // computed when asked for
  Handle<Pose> base_, base_last_;  // known always
};

}  // namespace murosimf
