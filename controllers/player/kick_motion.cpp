#include "kick_motion.h"

namespace murosimf::controllers {

namespace {

/// One row of the kick with the right foot; angles in degrees.
struct KickRow {
  double duration;
  double shoulder_right, shoulder_left;
  LegAngles right, left;
  bool evenly = false;
};

constexpr LegAngles kShiftedRight{-.4, -18.3, -26.3, 54.4, -29.3, 18.3};
constexpr LegAngles kShiftedLeft{-.3, -13.3, -28.4, 58.7, -31.5, 14.3};
constexpr LegAngles kStandingLeft{-.3, -11.0, -28.4, 58.7, -31.5, 14.3};
constexpr LegAngles kKickedRight{-4.1, -19.7, -59.4, 66.8, -19.4, 20.1};

constexpr KickRow kRows[] = {
    {.62, 20, 20, kShiftedRight, kShiftedLeft},                                // shift the weight
    {.26, 9.3, 30.7, {-4.4, -24.1, -27.8, 84.3, -67.2, 24.5}, kStandingLeft},  // lift, swing back
    {.135, 40.9, -.9, kKickedRight, kStandingLeft, true},                      // kick
    {.15, 40.9, -.9, kKickedRight, kStandingLeft},                             // hold
    {.45, 20, 20, {-.4, -20.5, -36.2, 74.7, -39.6, 20.5}, kStandingLeft},      // back
    {.47, 20, 20, kShiftedRight, kShiftedLeft},                                // put down
};
constexpr double kLastDuration = .50;  // to walk-ready

void setLeg(JointAngles& angles, int side, const LegAngles& degrees_of_right_foot_kick, double mirror) {
  const LegAngles& d = degrees_of_right_foot_kick;
  double* leg = angles.data() + kFirstLegJoint[static_cast<std::size_t>(side)];
  for (const int i : {0, kHipRoll, kAnkleRoll}) leg[i] = degrees(mirror * d[static_cast<std::size_t>(i)]);
  for (const int i : {kHipPitch, kKnee, kAnklePitch}) leg[i] = degrees(d[static_cast<std::size_t>(i)]);
}

void setArm(JointAngles& angles, int side, double shoulder_pitch) {
  double* arm = angles.data() + kFirstArmJoint[static_cast<std::size_t>(side)];
  arm[0] = degrees(shoulder_pitch), arm[1] = sideSign(side) * degrees(15), arm[2] = degrees(-60);
}

}  // namespace

std::vector<KeyFrame> kickFrames(int foot, const JointAngles& walk_ready) {
  const int standing = 1 - foot;
  const double mirror = foot == kRight ? 1.0 : -1.0;
  std::vector<KeyFrame> frames;
  for (const KickRow& row : kRows) {
    KeyFrame frame{row.duration, {}, row.evenly};
    setLeg(frame.angles, foot, row.right, mirror);
    setLeg(frame.angles, standing, row.left, mirror);
    setArm(frame.angles, foot, row.shoulder_right);
    setArm(frame.angles, standing, row.shoulder_left);
    frames.push_back(frame);
  }
  frames.push_back({kLastDuration, walk_ready, false});
  return frames;
}

// No correction at the hip's roll: it makes the robot fall.
void addKickFeedback(int foot, const Vector3& angular_velocity, JointAngles& angles) {
  double* standing = angles.data() + kFirstLegJoint[static_cast<std::size_t>(1 - foot)];
  standing[kAnklePitch] += 0.10 * angular_velocity.y;
  standing[kHipPitch] += 0.10 * angular_velocity.y;
  standing[kAnkleRoll] += 0.20 * angular_velocity.x;
}

}  // namespace murosimf::controllers
