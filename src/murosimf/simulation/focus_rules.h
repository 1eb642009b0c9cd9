#pragma once

/// @file Focus: robots are simulated closely where it matters, and cheaply elsewhere.
///
/// A robot goes to its near level of detail when the ball, or another robot, comes nearer than a distance of its rule,
/// and back to its far level when all have gone farther away than that distance and a margin, and it stands: who has
/// fallen or gets up stays at the near level. Distances are those of the origins of the bases, and of the ball's
/// centre, in the ground plane.
/// State      none but the robots' levels: a continued run decides the same.
/// Acts       through the intervention queue, whenever the steps of all of a robot's levels end together.
/// Cost       per robot with a rule and decision one distance to each robot and free body.

#include <vector>

#include "murosimf/simulation/simulation.h"

namespace murosimf {

struct FocusRule {
  ObjectId robot;
  int near_level = 1, far_level = 0;  ///< numbers of levels of detail
  double ball = 1, robots = 1;        ///< the distances [m]; 0: these do not count
  double margin = 0.2;                ///< [m]
};

class FocusRules final : public FrameObserver {
 public:
  FocusRules(Simulation& simulation, const std::vector<FocusRule>& rules);
  void afterFrame(Simulation& simulation) override;

 private:
  struct Watched {
    FocusRule rule;
    LevelExchanger exchanger;
    const Resident* resident = nullptr;
    Handle<Pose> base;
  };
  /// Whether anything is nearer to the robot than the distances of its rule and `more`.
  bool isNear(const Watched& watched, double more) const;

  std::vector<Watched> watched_;
  std::vector<Handle<Pose>> robots_, balls_;
};

}  // namespace murosimf
