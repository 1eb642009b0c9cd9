#pragma once

/// @file Where the cameras were when they saw what arrives only now, and how far the robot has gone since.
///
/// Pictures and sights come late: what they show lies in R of then. By odometry since, with T: R then,
///   X_RC(t) = X_RT X_TC,   X_RT = X_OR^-1 X_OT,   O: where R was when the memory began
/// the camera of then stands in R of now, so that all that is seen through it lies in R of now. Things that move by
/// themselves have moved on.
///
/// Remembers a few steps, and from then on as many as something has been late: late things are rare.

#include <vector>

#include "murosimf/control/client/state_archive.h"
#include "plane.h"
#include "posture.h"

namespace murosimf::controllers {

class CameraPast {
 public:
  CameraPast();
  /// Once a step: R has moved by `increment` (pose of the new R in the old R) since the step before.
  void remember(double time, const PlanarPose& increment, const Posture& posture);
  /// The robot was put elsewhere: what was before tells nothing.
  void forget() { count_ = 0; }
  /// Looks for things of this time: how far back to remember from now on.
  void expect(double time);
  /// X_RC of that time, in R as it is now; of the oldest step remembered for times before it.
  Pose pose(std::size_t camera, double time) const;
  /// X_TR: R of now in R of that time.
  PlanarPose movedSince(double time) const;
  std::size_t cameras() const { return count_ == 0 ? 0 : newest().X_TC.size(); }
  void archive(client::StateArchive& archive);

 private:
  struct Step {
    double time = 0;
    PlanarPose X_OT;
    std::vector<Pose> X_TC;
    void archive(client::StateArchive& archive) { archive(time, X_OT, X_TC); }
  };
  const Step& stepBefore(std::size_t steps) const { return ring_[(next_ + kMost - 1 - steps) % kMost]; }
  const Step& newest() const { return stepBefore(0); }
  const Step& at(double time) const;

  static constexpr std::size_t kLeast = 4, kMost = 256;  // steps
  std::vector<Step> ring_;
  std::size_t next_ = 0, count_ = 0, wanted_ = kLeast;
};

}  // namespace murosimf::controllers
