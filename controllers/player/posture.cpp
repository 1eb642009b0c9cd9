#include "posture.h"

#include <algorithm>
#include <stdexcept>

#include "ks21.h"

namespace murosimf::controllers {

namespace {

// A sole must be this much below the other one to take over: more than rounding and servo noise, less than any step.
constexpr double kExchangeDepth = 1e-4;

Pose moved(double x, double y, double z) { return {{}, {x, y, z}}; }
Pose turned(const Rotation3& rotation) { return {rotation, {}}; }

double angle(std::span<const client::JointReading> joints, int index) {
  return joints[static_cast<std::size_t>(index)].position;
}

/// Sole in the pelvis.
Pose solePose(std::span<const client::JointReading> joints, int side) {
  const int first = kFirstLegJoint[static_cast<std::size_t>(side)];
  const Rotation3 hip = rotationZ(angle(joints, first)) * rotationX(angle(joints, first + kHipRoll));
  const Pose thigh{hip * rotationY(angle(joints, first + kHipPitch)), {0, sideSign(side) * kHipHalfDistance, 0}};
  const Pose shank = thigh * moved(0, 0, -kThigh) * turned(rotationY(angle(joints, first + kKnee)));
  const Rotation3 ankle = rotationY(angle(joints, first + kAnklePitch)) * rotationX(angle(joints, first + kAnkleRoll));
  return shank * moved(0, 0, -kShank) * turned(ankle) * moved(kSoleForward, 0, -kSoleDown);
}

/// Height of the lowest corner of sole B over the plane of sole A [m].
double lowestCorner(const Pose& X_AB) {
  double lowest = 1e9;
  for (const double x : {-0.5 * kSoleLength, 0.5 * kSoleLength}) {
    for (const double y : {-0.5 * kSoleWidth, 0.5 * kSoleWidth}) lowest = std::min(lowest, (X_AB * Vector3{x, y, 0}).z);
  }
  return lowest;
}

double headingOf(const Pose& X) { return atan2(X.rotation.x.y, X.rotation.x.x); }

Pose trunkPose(std::span<const client::JointReading> joints) {
  return moved(0, 0, kWaistHeight) * turned(rotationZ(angle(joints, kWaistYaw)));
}

Pose headPose(std::span<const client::JointReading> joints) {
  return trunkPose(joints) * moved(0, 0, kNeckHeight) * turned(rotationZ(angle(joints, kHeadPan))) *
         moved(kTiltForward, 0, kTiltUp) * turned(rotationY(angle(joints, kHeadTilt)));
}

}  // namespace

Posture computePosture(const client::RobotDescription& robot, std::span<const client::JointReading> joints,
                       int previous_stance) {
  if (joints.size() != kJointCount) throw std::invalid_argument("posture: a KS21 has 21 joints");
  const std::array<Pose, 2> X_PF{solePose(joints, kRight), solePose(joints, kLeft)};
  Posture posture;
  posture.stance = previous_stance;
  const auto before = static_cast<std::size_t>(previous_stance);
  if (lowestCorner(inverse(X_PF[before]) * X_PF[1 - before]) < -kExchangeDepth) posture.stance = 1 - previous_stance;

  const Pose X_SP = inverse(X_PF[static_cast<std::size_t>(posture.stance)]);  // the stance sole lies in the ground
  const Pose X_SR{rotationZ(headingOf(X_SP)), {X_SP.translation.x, X_SP.translation.y, 0}};
  posture.X_RP = inverse(X_SR) * X_SP;
  for (std::size_t side = 0; side < 2; ++side) posture.X_RF[side] = posture.X_RP * X_PF[side];

  posture.X_RC.reserve(robot.cameras.size());
  for (const client::CameraDescription& camera : robot.cameras) {
    const bool on_head = camera.body == kHeadBody;
    posture.X_RC.push_back(posture.X_RP * (on_head ? headPose(joints) : trunkPose(joints)) * camera.X_BC);
  }
  return posture;
}

PlanarPose odometryIncrement(const Posture& before, const Posture& now) {
  const auto foot = static_cast<std::size_t>(now.stance);
  const Pose X_BN = before.X_RF[foot] * inverse(now.X_RF[foot]);
  return {X_BN.translation.x, X_BN.translation.y, headingOf(X_BN)};
}

}  // namespace murosimf::controllers
