#pragma once

/// @file Obstacles of a scenario -> what the world knows of them. Frame O: on the ground below the middle, z up.

#include "murosimf/scene/robot_builder.h"
#include "murosimf/scene/scene.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// Of one that stands fast.
PlacedShape obstacleShape(const ObstacleSettings& obstacle);
/// Of one that can be pushed and knocked over: a robot of one homogeneous body without joints.
RobotBlueprint obstacleBlueprint(const ObstacleSettings& obstacle);
/// How it is simulated: multibody dynamics without sensors.
RobotSettings obstacleAsRobot(const ObstacleSettings& obstacle);

}  // namespace murosimf
