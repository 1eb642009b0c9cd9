#pragma once

/// @file A robot without mass for closed-loop tests: every joint is where it is commanded, the lower sole never slips.
///
/// It moves by the rule of kinematic walking [Friedmann 2007, 3.2]: the stance sole stays in place, the other one takes
/// over when it gets below it.

#include <vector>

#include "player/ks21.h"
#include "player/plane.h"
#include "player/posture.h"

namespace murosimf::controllers {

/// Pose of b in a.
inline PlanarPose between(const PlanarPose& a, const PlanarPose& b) {
  const SinCos<double> t = sincos(a.heading);
  const double dx = b.x - a.x, dy = b.y - a.y;
  return {t.cos * dx + t.sin * dy, -t.sin * dx + t.cos * dy, wrapAngle(b.heading - a.heading)};
}

inline client::RobotDescription makeRobot() {
  client::RobotDescription robot;
  robot.joints.resize(kJointCount);
  for (std::size_t i = 0; i < kJointNames.size(); ++i) robot.joints[i].name = kJointNames[i];
  robot.cameras.resize(2);
  robot.cameras[0].body = std::string(kHeadBody), robot.cameras[1].body = "trunk";
  const Rotation3 R_BC{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};  // C: x right, y down, z forward
  robot.cameras[0].width = 640, robot.cameras[0].height = 480;
  robot.cameras[0].fx = robot.cameras[0].fy = 554.26, robot.cameras[0].cx = 319.5, robot.cameras[0].cy = 239.5;
  robot.cameras[1].width = 320, robot.cameras[1].height = 240;
  robot.cameras[1].fx = robot.cameras[1].fy = 134.26, robot.cameras[1].cx = 159.5, robot.cameras[1].cy = 119.5;
  robot.cameras[0].X_BC = {R_BC, {kEyeForward, 0, kEyeUp}};
  robot.cameras[1].X_BC = {rotationY(degrees(20)) * R_BC, {0.055, 0, 0.070}};
  robot.field = {4.5, 3.0, 1.5, 0.9, 0.5, 0.04, 0.05, 0.5, 0.6, 0.5, 1.9, 0.0, 0.0, 1.5, 0.07, 0.1, 0.6};
  return robot;
}

class Puppet {
 public:
  explicit Puppet(const PlanarPose& start = {}) : pose_(start), readings_(kJointCount) {}

  void move(const JointAngles& angles) {
    for (std::size_t i = 0; i < angles.size(); ++i) {
      readings_[i].velocity = (angles[i] - readings_[i].position) / 0.01;
      readings_[i].position = angles[i];
    }
    const Posture now = computePosture(robot_, readings_, posture_.stance);
    if (moved_) pose_ = compose(pose_, odometryIncrement(posture_, now));
    posture_ = now, moved_ = true;
  }
  /// Puts it elsewhere by hand; the joints stay.
  void place(const PlanarPose& pose) { pose_ = pose; }
  const PlanarPose& pose() const { return pose_; }  ///< of frame R on the field
  const Posture& posture() const { return posture_; }
  const std::vector<client::JointReading>& readings() const { return readings_; }
  const client::RobotDescription& robot() const { return robot_; }

 private:
  client::RobotDescription robot_ = makeRobot();
  PlanarPose pose_;
  std::vector<client::JointReading> readings_;
  Posture posture_;
  bool moved_ = false;
};

}  // namespace murosimf::controllers
