#pragma once

/// @file Which motion a robot has from when on: "kinematic_walking, multibody_dynamics@12.5, kinematic_walking@20".
///
/// Each distinct motion is a level of detail that the robot is linked with. A motion without a time is that of the
/// start; where all have one, the robot starts with that of its level.

#include <string>
#include <vector>

#include "murosimf/scene/located.h"
#include "murosimf/world/diagnostics.h"

namespace murosimf {

struct MotionPlan {
  std::vector<std::string> motions;  ///< module of each level of detail, that of the start first
  struct Change {
    double time = 0;  ///< [s]
    int level = 0;    ///< number in `motions`
  };
  std::vector<Change> changes;  ///< in the order of time
  int near_level = -1;          ///< of the robot's focus rule; -1: it has none

  /// Number of the level with this motion; added where it is new.
  int levelWith(const std::string& motion);
};

/// Reads a plan; `usual` is the motion of the start where the text names none. Reports what is no motion at a time,
/// times that do not rise, and a start in the middle.
MotionPlan readMotionPlan(const Located<std::string>& text, const std::string& usual, const std::string& robot,
                          Diagnostics& diagnostics);

}  // namespace murosimf
