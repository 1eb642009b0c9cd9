#pragma once

/// @file What control software is told of a robot's wheels, range sensors, touch sensors and devices.

#include "murosimf/control/client/robot_description.h"
#include "murosimf/robot/robot_model.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// Adds them to a description; all places are on the robot's base, joints at zero.
/// @param robot  object of the world, whose properties the scenario may have changed
void describeMounts(const World& world, ObjectId robot, const RobotModel& model, client::RobotDescription& d);

/// Adds the devices of the player API; d.soles must be there already.
void describeDevices(const RobotModel& model, client::RobotDescription& d);

}  // namespace murosimf
