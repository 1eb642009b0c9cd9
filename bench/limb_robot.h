#pragma once

/// @file A robot with as many joints as wanted: a trunk on two legs of five joints, the rest in arms of five.

#include "murosimf/scene/robot_builder.h"

namespace murosimf::bench {

/// Stands with all joints at 0. Arms are spread evenly around the trunk.
/// @param joints  a multiple of 10, at least 10
RobotBlueprint limbRobot(int joints);

}  // namespace murosimf::bench
