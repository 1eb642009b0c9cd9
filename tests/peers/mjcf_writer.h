#pragma once

/// @file A robot as MuJoCo's model text (MJCF), made from the flattened tree that our kernels walk.
///
/// Body and joint of row i are called "body<i>" and "joint<i - 1>". The base floats; joints have the rotor's inertia
/// and viscous friction; each has a position actuator with gains and torque limit of its servo, in the order of joints.
/// The ground is the plane z = 0, only soles touch it and nothing else touches anything. Sensors: positions of all
/// joints, velocities of all joints, then gyroscope and accelerometer of the first inertial unit.
///
/// Left out: the motor's loss of torque with speed (the actuator's limit is the stall torque), limits of joints.

#include <string>

#include "peers/peer_scene.h"

namespace murosimf::peers {

std::string mjcfOf(const PeerScene& scene);

}  // namespace murosimf::peers
