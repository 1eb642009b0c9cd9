#pragma once

/// @file What every simulator of the comparison is given, and what it gives back: the same robot on the same ground.

#include <compare>
#include <vector>

#include "murosimf/math/spatial.h"
#include "murosimf/scene/robot_builder.h"
#include "murosimf/world/surface_table.h"

namespace murosimf::peers {

/// Robot, ground and step. Gains, torque limits, rotors and friction of joints are those of the robot's file.
struct PeerScene {
  const RobotBlueprint& robot;
  double step = 1e-3;     ///< [s]
  double friction = 0.7;  ///< Coulomb's, soles on the ground
  bool servos = true;     ///< false: joints are driven by torques alone
};

/// Robots of one kind in one world, with all shapes that collide: on the ground and on one another, not each on itself.
struct PeerHeap {
  const RobotBlueprint& robot;
  const SurfaceTable& surfaces;  ///< of which the peers take friction alone
  int robots = 1;
  double step = 1e-3;          ///< [s]
  double contact_time = 0.02;  ///< of MuJoCo's contacts, its solref: bodies sink in with its square [s]
};

/// A body of a scene.
struct PeerBody {
  int robot = -1;  ///< -1: the ground
  int row = 0;     ///< of the flattened tree
  friend auto operator<=>(const PeerBody&, const PeerBody&) = default;
};

/// Where a robot is and how it moves.
struct PeerState {
  Pose X_WB;                  ///< of the base
  SpatialMotion<double> V_B;  ///< w and v of the base's origin, base axes
  std::vector<double> q, dq;  ///< in the order of the robot's joints
};

/// What control software reads after each frame, without noise.
struct PeerSensors {
  std::vector<double> q, dq;
  Vector3 gyroscope, accelerometer;  ///< of the first inertial unit, its axes

  explicit PeerSensors(const RobotBlueprint& robot)
      : q(robot.model.tree.joints.size()), dq(robot.model.tree.joints.size()) {}
};

inline constexpr double kSoleThickness = 0.012;  ///< of the boxes that stand for soles [m]

/// Row of a sole and the centre of its box: its lower face is the sole.
inline RowPlace soleBox(const RobotBlueprint& robot, const Sole& sole) {
  const RowPlace& body = robot.flat.bodies[static_cast<std::size_t>(sole.body)];
  return {body.row, body.X_RB * sole.X_BSole * Pose{{}, {0, 0, kSoleThickness / 2}}};
}

}  // namespace murosimf::peers
