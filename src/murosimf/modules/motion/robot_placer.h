#pragma once

/// @file Puts a robot somewhere, at rest, from outside of its modules: a referee's hand.
///
/// It writes placement and counts it; motion that is prescribed obeys in its next step. A robot whose motion obeys
/// contacts has its state set: base_pose where it stands with the joint positions it has (StandingPose), all velocities
/// zero.

#include <vector>

#include "murosimf/linking/linked_world.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/modules/motion/standing_pose.h"

namespace murosimf {

class RobotPlacer {
 public:
  /// What it gives to robots: attach this when linking.
  static const OutsideAccess& robotAccess();

  RobotPlacer(const World& world, LinkedWorld& linked, ObjectId robot);
  ObjectId robot() const { return robot_; }
  /// Between two frames. Allocates nothing.
  void place(const PlanarPose& pose);
  /// After an exchange of levels: does what was asked of the motion that has left before it obeyed.
  void catchUp();

 private:
  void setState(const PlanarPose& pose);

  ObjectId robot_;
  Handle<PlanarPose> placement_;
  Handle<double> count_, shown_;
  Handle<double> q_, dq_;
  Handle<Pose> base_pose_;
  Handle<SpatialMotion<double>> base_velocity_;  // of motion that obeys contacts
  StandingPose standing_;
  std::vector<double> positions_;
};

}  // namespace murosimf
