#pragma once

/// @file RobotModel -> objects of the world: what modules, ports and cameras know of a robot.

#include <string>
#include <string_view>

#include "murosimf/robot/flatten_tree.h"
#include "murosimf/robot/robot_model.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// A robot file, read and flattened once for all robots that use it.
struct RobotBlueprint {
  RobotModel model;
  FlatTree flat;
};

/// The robot's cameras, in the order of its file.
inline constexpr std::string_view kCamerasSubset = "cameras";

/// Adds the robot `path` ("robots.red.1") with its joints, bodies (one object per row of the tree table) and cameras
/// below it, and sets their constants. Shapes drawn in the team's colour get `team_colour`.
/// The robot's own mass is left to the caller, who may change masses of bodies first.
ObjectId addRobot(World& world, const std::string& path, const RobotBlueprint& blueprint, const Colour& team_colour);

/// The name of the object of a row: its first body's.
const std::string& rowName(const RobotBlueprint& blueprint, int row);

}  // namespace murosimf
