#pragma once

/// @file Moves one robot from a level of detail to another, with as much of its motion as the new one can carry.
///
/// Positions are continuous: both levels have them (LinkedWorld::exchange). A level that has base_velocity gets that of
/// the old level; from motion that is prescribed it is the mean over its last step,
///     w = log(R_last^T R) / dt,   v = R^T (p - p_last) / dt     in the base's axes.
/// An exchange waits until the steps of all of the robot's levels end together, so that no step is left half made.

#include "murosimf/linking/linked_world.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

class LevelExchanger {
 public:
  /// What it takes of and gives to robots: attach this when linking.
  static const OutsideAccess& robotAccess();

  LevelExchanger(LinkedWorld& linked, ObjectId robot);
  int levelCount() const { return levels_; }
  /// Whether the robot can be exchanged at the beginning of this frame.
  bool ready(long frame) const { return frame % period_ == 0; }
  void exchange(int level);

 private:
  SpatialMotion<double> baseVelocity() const;

  LinkedWorld& linked_;
  ObjectId robot_;
  int levels_;
  long period_ = 1;  // in frames, common to all levels
  Handle<Pose> base_pose_, base_pose_last_;
  Handle<SpatialMotion<double>> base_velocity_;
};

}  // namespace murosimf
