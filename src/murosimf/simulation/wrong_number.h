#pragma once

/// @file Which number of a robot's state is none: for the message about a robot that was frozen.

#include <string>

#include "murosimf/linking/linked_world.h"

namespace murosimf {

/// "joint_velocity of robots.red.2.left_knee is nan", of the state of the moment. Looks up columns by name.
std::string wrongNumberOf(const World& world, LinkedWorld& linked, ObjectId robot);

}  // namespace murosimf
