#pragma once

/// @file Robots as MuJoCo's model text (MJCF), made from the flattened tree that our kernels walk.
///
/// Of robot r, body and joint of row i are called "robot<r>_body<i>" and "robot<r>_joint<i - 1>". The base floats
/// ("robot<r>_base"); joints have the rotor's inertia and viscous friction; each has a position actuator with gains and
/// torque limit of its servo, in the order of joints, robot by robot. The ground is the plane z = 0. Sensors, robot by
/// robot: positions of all joints, velocities of all joints, then gyroscope and accelerometer of the first inertial
/// unit.
///
/// One robot    only soles touch the ground and nothing else touches anything.
/// Heap         all shapes that collide touch the ground and those of other robots: each robot is a contact type of its
///              own, which does not go together with itself. MuJoCo takes the larger friction of two geoms: shapes have
///              that of their surface with itself, and every surface has a ground of its own, with the friction of
///              both.
///
/// Left out: the motor's loss of torque with speed (the actuator's limit is the stall torque), limits of joints.

#include <string>

#include "peers/peer_scene.h"

namespace murosimf::peers {

std::string mjcfOf(const PeerScene& scene);
/// @throws std::invalid_argument where the table lacks a pair, or MuJoCo's rule would make another friction of it; for
/// more robots and surfaces than there are contact types.
std::string mjcfOf(const PeerHeap& heap);

}  // namespace murosimf::peers
