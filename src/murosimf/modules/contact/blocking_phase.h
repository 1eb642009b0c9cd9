#pragma once

/// @file Keeps kinematic robots from walking through one another and through posts.
///
/// After each update of a robot's motion it supposes that the base goes on in the plane as it just walked, lets
/// algorithms/blocking.h say which part of that way is free, and gives the difference as planar_shift, which the motion
/// module adds in its next step. Robots need blocking_radius; static cylinders and capsules that stand upright block as
/// well, and so do robots whose motion obeys contacts: nothing here moves them.

#include <vector>

#include "murosimf/algorithms/blocking.h"
#include "murosimf/linking/linked_world.h"
#include "murosimf/linking/outside_access.h"

namespace murosimf {

class BlockingPhase {
 public:
  /// What it takes of and gives to robots: attach this when linking.
  static const OutsideAccess& robotAccess();

  BlockingPhase(const World& world, LinkedWorld& linked, std::vector<ObjectId> robots, std::vector<ObjectId> fixed);
  /// Looks at the robots whose motion was updated in this frame.
  void advance(long frame);

 private:
  struct Robot {
    Handle<Pose> pose, last;
    Handle<Vector3> shift;
    /// Asks the memory for what a frame reads.
    void fetch(long frame) const {
      pose.values().fetch(&Pose::translation);
      if (!last.valid() || frame % pose.period() != 0) return;
      last.values().fetch(&Pose::translation);
      shift.values().fetch(1);
    }
  };
  std::vector<Robot> robots_;
  std::vector<BlockingDisc> discs_;   // the robots in their order, then the posts
  std::vector<BlockingDisc> wanted_;  // the robots' discs before the rule
  BlockingRule rule_;
  double frame_length_;
};

}  // namespace murosimf
