#include "player/posture.h"

#include <gtest/gtest.h>

#include "player/leg_inverse_kinematics.h"
#include "player/walking_engine.h"
#include "puppet.h"

namespace murosimf::controllers {
namespace {

std::vector<client::JointReading> readings(const JointAngles& angles) {
  std::vector<client::JointReading> joints(kJointCount);
  for (std::size_t i = 0; i < angles.size(); ++i) joints[i].position = angles[i];
  return joints;
}

TEST(Posture, StandsUprightOnStraightLegs) {
  const Posture posture = computePosture(makeRobot(), readings({}), kLeft);
  EXPECT_NEAR(posture.X_RP.translation.z, 0.285, 1e-12);
  EXPECT_NEAR(posture.X_RF[kRight].translation.y, -0.045, 1e-12);
  EXPECT_NEAR(posture.X_RF[kRight].translation.z, 0, 1e-12);
  const Pose& head = posture.X_RC[0];
  EXPECT_NEAR(head.translation.x, 0.040, 1e-12);
  EXPECT_NEAR(head.translation.z, 0.285 + 0.040 + 0.145 + 0.020 + 0.030, 1e-12);
  EXPECT_NEAR(head.rotation.z.x, 1, 1e-12);                   // looks ahead
  EXPECT_NEAR(posture.X_RC[1].rotation.z.z, -0.34202, 1e-5);  // the chest camera looks 20 degrees down
}

TEST(Posture, AgreesWithInverseKinematics) {
  const Pose X_PF{fromRollPitchYaw(Vector3{0.05, -0.11, 0.2}), {0.02, 0.06, -0.20}};  // ankle frame of the left foot
  JointAngles q = walkingPose({}, 0, 0, {});
  const LegAngles leg = solveLeg(X_PF.translation - Vector3{0, kHipHalfDistance, 0}, X_PF.rotation).angles;
  std::copy(leg.begin(), leg.end(), q.begin() + kFirstLegJoint[kLeft]);
  for (int i = 0; i < 6; ++i) q[static_cast<std::size_t>(kFirstLegJoint[kRight] + i)] = 0;
  q[kFirstLegJoint[kRight] + kKnee] = degrees(130);  // right foot well above the ground
  const Posture posture = computePosture(makeRobot(), readings(q), kLeft);
  EXPECT_EQ(posture.stance, kLeft);
  const Pose found = inverse(posture.X_RP) * posture.X_RF[kLeft];
  const Pose wanted = X_PF * Pose{{}, {kSoleForward, 0, -kSoleDown}};
  EXPECT_NEAR(norm(found.translation - wanted.translation), 0, 1e-12);
  EXPECT_NEAR(norm(rotationLog(transposed(found.rotation) * wanted.rotation)), 0, 1e-9);
  EXPECT_NEAR(posture.X_RF[kLeft].rotation.z.z, 1, 1e-12);  // flat on the ground
  EXPECT_NEAR(posture.X_RP.translation.x, 0, 1e-12);        // R lies below the hips
  EXPECT_NEAR(posture.X_RP.rotation.x.y, 0, 1e-12);         // and looks where the pelvis looks
}

TEST(Posture, WalkReadyPoseHasThePelvisAt246Millimetres) {
  const Posture posture = computePosture(makeRobot(), readings(walkingPose({}, 0, 0, {})), kLeft);
  EXPECT_NEAR(posture.X_RP.translation.z, 0.246, 5e-4);
  EXPECT_NEAR(toRollPitchYaw(posture.X_RP.rotation).y, degrees(6.5), 1e-9);
}

TEST(Posture, LowerFootCarriesTheRobot) {
  const JointAngles left_swings = walkingPose({}, 0.25, 1, {});
  EXPECT_EQ(computePosture(makeRobot(), readings(left_swings), kLeft).stance, kRight);
  const JointAngles right_swings = walkingPose({}, 0.75, 1, {});
  EXPECT_EQ(computePosture(makeRobot(), readings(right_swings), kRight).stance, kLeft);
  const JointAngles both_down = walkingPose({}, 0, 1, {0.1, 0, 0});
  EXPECT_EQ(computePosture(makeRobot(), readings(both_down), kRight).stance, kRight);
  EXPECT_EQ(computePosture(makeRobot(), readings(both_down), kLeft).stance, kLeft);
}

TEST(Posture, RefusesAnotherRobot) {
  EXPECT_THROW(computePosture(makeRobot(), std::vector<client::JointReading>(20), kLeft), std::invalid_argument);
}

}  // namespace
}  // namespace murosimf::controllers
