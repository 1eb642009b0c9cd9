#pragma once

/// @file How the robot stands, computed by the control software from its joint sensors alone.

#include <array>
#include <span>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"

namespace murosimf::controllers {

/// Frame R: origin on the ground below the middle of the hips, x in the pelvis' heading, z up.
struct Posture {
  Pose X_RP;                 ///< pelvis
  std::array<Pose, 2> X_RF;  ///< soles: centre of the bottom face, right and left
  std::vector<Pose> X_RC;    ///< cameras as in RobotDescription::cameras (C: x right, y down, z forward)
  int stance = 1;            ///< foot that carries the robot, 0 right, 1 left: its sole lies flat on the ground
};

/// The posture of a KS21 with one sole flat on the ground (the lower one; `previous_stance` when both are equal).
Posture computePosture(const client::RobotDescription& robot, std::span<const client::JointReading> joints,
                       int previous_stance);

/// How far R moved between two postures while the stance foot of `now` stayed in place: pose of the new R in the old R.
PlanarPose odometryIncrement(const Posture& before, const Posture& now);

}  // namespace murosimf::controllers
