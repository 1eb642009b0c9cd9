/// @file The numbers of robots/ks21.urdf: what was designed is what is read.

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/robot/flatten_tree.h"
#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

constexpr double kDegree = kPi / 180;

const RobotModel& ks21() {
  static const RobotModel model = [] {
    Diagnostics diagnostics;
    ReadResult result = readUrdf(MUROSIMF_SOURCE_DIR "/robots/ks21.urdf", diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    return result ? *result : RobotModel{};
  }();
  return model;
}

/// Frames of all bodies in the base for joint positions q.
std::vector<Pose> bodyPoses(const KinematicTree& tree, const std::vector<double>& q) {
  const std::vector<Pose> elements = elementPoses(tree, q);
  std::vector<Pose> poses;
  for (const Body& body : tree.bodies) poses.push_back(elements[static_cast<std::size_t>(body.element)]);
  return poses;
}

const Body& body(const char* name) {
  return ks21().tree.bodies.at(static_cast<std::size_t>(ks21().tree.bodyIndex(name)));
}
const Joint& joint(const char* name) {
  return ks21().tree.joints.at(static_cast<std::size_t>(ks21().tree.jointIndex(name)));
}

TEST(Ks21, HasTwentyOneJointsAndBodiesOf3300Grams) {
  EXPECT_EQ(ks21().tree.joints.size(), 21U);
  EXPECT_EQ(ks21().tree.bodies.size(), 22U);
  EXPECT_NEAR(ks21().tree.mass(), 3.3, 1e-12);
}

TEST(Ks21, JointsStandInTheOrderOfControlFrames) {
  const std::vector<std::string> expected{
      "waist_yaw",           "head_pan",          "head_tilt",           "shoulder_pitch_right",
      "shoulder_roll_right", "elbow_right",       "shoulder_pitch_left", "shoulder_roll_left",
      "elbow_left",          "hip_yaw_right",     "hip_roll_right",      "hip_pitch_right",
      "knee_right",          "ankle_pitch_right", "ankle_roll_right",    "hip_yaw_left",
      "hip_roll_left",       "hip_pitch_left",    "knee_left",           "ankle_pitch_left",
      "ankle_roll_left"};
  std::vector<std::string> found;
  for (const Joint& j : ks21().tree.joints) found.push_back(j.name);
  EXPECT_EQ(found, expected);
}

TEST(Ks21, StandsStraight550MillimetresHighOnItsSoles) {
  const std::vector<Pose> poses = bodyPoses(ks21().tree, std::vector<double>(21, 0.0));
  double top = -1, bottom = 1;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (const BodyShape& s : ks21().tree.bodies[i].shapes) {
      const double z = (poses[i] * s.X_BS.translation).z;
      top = std::max(top, z + s.shape.half_size.z);
      bottom = std::min(bottom, z - s.shape.half_size.z);
    }
  }
  EXPECT_NEAR(top - bottom, 0.550, 1e-12);
  EXPECT_NEAR(bottom, -0.285, 1e-12);
  for (const Sole& sole : ks21().soles) {
    const Pose X_WSole = poses.at(static_cast<std::size_t>(sole.body)) * sole.X_BSole;
    EXPECT_NEAR(X_WSole.translation.z, bottom, 1e-12);
    EXPECT_NEAR(X_WSole.translation.y, sole.side == Side::kLeft ? 0.045 : -0.045, 1e-12);
  }
}

TEST(Ks21, CentreOfMassLies4MillimetresAboveTheHipCentreWithStraightLegs) {
  const std::vector<Pose> poses = bodyPoses(ks21().tree, std::vector<double>(21, 0.0));
  MassProperties whole;
  for (std::size_t i = 0; i < poses.size(); ++i) whole = welded(whole, moved(poses[i], ks21().tree.bodies[i].mass));
  EXPECT_NEAR(whole.p_BC_B.z, 0.0041, 5e-5);
  EXPECT_NEAR(whole.p_BC_B.y, 0, 1e-12);
  EXPECT_NEAR(whole.mass, 3.3, 1e-12);
}

TEST(Ks21, LimitsAreMirroredAndAxesAreNot) {
  EXPECT_NEAR(joint("hip_roll_right").limits.lower, -60 * kDegree, 1e-9);
  EXPECT_NEAR(joint("hip_roll_right").limits.upper, 35 * kDegree, 1e-9);
  EXPECT_NEAR(joint("hip_roll_left").limits.lower, -35 * kDegree, 1e-9);
  EXPECT_NEAR(joint("hip_roll_left").limits.upper, 60 * kDegree, 1e-9);
  EXPECT_NEAR(joint("shoulder_roll_right").limits.lower, -120 * kDegree, 1e-9);
  EXPECT_EQ(joint("shoulder_roll_right").limits.upper, 0);
  EXPECT_EQ(joint("shoulder_roll_left").limits.lower, 0);
  EXPECT_NEAR(joint("knee_left").limits.upper, 135 * kDegree, 1e-9);
  EXPECT_NEAR(joint("elbow_left").limits.lower, -130 * kDegree, 1e-9);
  EXPECT_NEAR(joint("ankle_pitch_left").limits.upper, 70 * kDegree, 1e-9);
  for (const char* name : {"hip_roll_right", "hip_roll_left"}) EXPECT_EQ(joint(name).axis, kAxisX);
}

TEST(Ks21, OnlyKneesHaveTheStrongServo) {
  for (const Joint& j : ks21().tree.joints) {
    ASSERT_TRUE(j.servo.has_value()) << j.name;
    const bool knee = j.name.starts_with("knee");
    EXPECT_EQ(j.servo->type == "RX-64", knee) << j.name;
    EXPECT_EQ(j.servo->stall_torque, knee ? 4.24 : 2.96);
    EXPECT_EQ(j.servo->kp, knee ? 45 : 30);
    EXPECT_NEAR(j.servo->kd, j.servo->stall_torque / j.servo->no_load_speed, 5e-4);
    EXPECT_EQ(j.limits.largest_torque, j.servo->stall_torque);
    EXPECT_EQ(j.servo->armature, 0.005);
  }
  EXPECT_EQ(ks21().joint_sensors.size(), 21U);
  EXPECT_NEAR(ks21().joint_sensors[0].resolution, 0.29 * kDegree, 2e-6);
}

TEST(Ks21, InertiasAreThoseOfTheBoxes) {
  for (const Body& b : ks21().tree.bodies) {
    Vector3 edges = b.shapes[0].shape.half_size * 2;
    if (b.name.starts_with("foot")) edges.z = 0.025;
    const MassProperties box = boxMass(b.mass.mass, edges, b.shapes[0].X_BS.translation);
    EXPECT_NEAR(b.mass.I_C_B.xx / box.I_C_B.xx, 1, 1e-9) << b.name;
    EXPECT_NEAR(b.mass.I_C_B.yy / box.I_C_B.yy, 1, 1e-9) << b.name;
    EXPECT_NEAR(b.mass.I_C_B.zz / box.I_C_B.zz, 1, 1e-9) << b.name;
    EXPECT_EQ(b.mass.p_BC_B, box.p_BC_B) << b.name;
  }
}

TEST(Ks21, CamerasHaveTheFocalLengthsOfTheirAnglesOfView) {
  ASSERT_EQ(ks21().cameras.size(), 2U);
  const CameraMount& chest = ks21().cameras[0];
  const CameraMount& head = ks21().cameras[1];
  EXPECT_NEAR(head.lens.fx, 554.26, 5e-3);
  EXPECT_NEAR(chest.lens.fx, 134.26, 5e-3);
  EXPECT_EQ(head.lens.fx, head.lens.fy);
  EXPECT_EQ(head.lens.cx, 319.5);  // pixel centres at integers: the middle of 0..639
  EXPECT_EQ(chest.lens.cy, 119.5);
  EXPECT_EQ(head.period, 0.05);
  EXPECT_EQ(head.lens.kc[4], -0.015);
  ASSERT_EQ(head.hidden_bodies.size(), 1U);
  EXPECT_EQ(ks21().tree.bodies[static_cast<std::size_t>(head.hidden_bodies[0])].name, "skull");
}

TEST(Ks21, ChestCameraLooks20DegreesDownAndIsUpright) {
  const Rotation3& R_BC = ks21().cameras[0].X_BC.rotation;
  EXPECT_NEAR(R_BC.z.x, std::cos(20 * kDegree), 1e-10);
  EXPECT_NEAR(R_BC.z.z, -std::sin(20 * kDegree), 1e-10);
  EXPECT_NEAR(R_BC.x.y, -1, 1e-12);                       // right is -y
  EXPECT_NEAR(R_BC.y.z, -std::cos(20 * kDegree), 1e-10);  // down
}

TEST(Ks21, NeighboursGrandparentsAndThighsIgnoreContact) {
  const auto ignores = [](const char* a, const char* b) {
    return ks21().ignoresContact(ks21().tree.bodyIndex(a), ks21().tree.bodyIndex(b));
  };
  EXPECT_TRUE(ignores("thigh_left", "shank_left"));
  EXPECT_TRUE(ignores("shank_left", "thigh_left"));
  EXPECT_TRUE(ignores("pelvis", "groin_right"));
  EXPECT_TRUE(ignores("pelvis", "thigh_right"));
  EXPECT_FALSE(ignores("pelvis", "shank_right"));
  EXPECT_FALSE(ignores("foot_left", "foot_right"));
  EXPECT_FALSE(ignores("forearm_left", "trunk"));
}

/// How deep two boxes with parallel axes lie in each other [m]; negative: the gap.
double overlap(const Pose& a, const Shape& shape_a, const Pose& b, const Shape& shape_b) {
  double least = 1;
  for (int i = 0; i < 3; ++i) {
    least = std::min(least, shape_a.half_size[i] + shape_b.half_size[i] - abs(a.translation[i] - b.translation[i]));
  }
  return least;
}

TEST(Ks21, StandingStraightNoBodyTouchesAnotherThatItMayTouch) {
  const std::vector<Body>& bodies = ks21().tree.bodies;
  const std::vector<Pose> poses = bodyPoses(ks21().tree, std::vector<double>(21, 0.0));
  int pairs = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (ks21().ignoresContact(static_cast<int>(a), static_cast<int>(b))) continue;
      for (const BodyShape& s : bodies[a].shapes) {
        for (const BodyShape& other : bodies[b].shapes) {
          if (!s.collides || !other.collides) continue;
          ++pairs;
          EXPECT_LT(overlap(poses[a] * s.X_BS, s.shape, poses[b] * other.X_BS, other.shape), -1e-3)
              << bodies[a].name << " " << bodies[b].name;
        }
      }
    }
  }
  EXPECT_GT(pairs, 60);
}

TEST(Ks21, FeetTouchWithTheirSolesAndCarryPressurePointsAtTheCorners) {
  EXPECT_EQ(body("foot_left").shapes[0].surface, "sole");
  EXPECT_EQ(body("trunk").shapes[0].surface, "plastic");
  ASSERT_EQ(ks21().pressure_sensors.size(), 2U);
  const PressureSensorMount& sensor = ks21().pressure_sensors[0];
  ASSERT_EQ(sensor.points.size(), 4U);
  EXPECT_NEAR(sensor.points[0].x, 0.075, 1e-12);
  EXPECT_NEAR(sensor.points[0].y, 0.04, 1e-12);
  EXPECT_NEAR(sensor.points[2].x, -0.055, 1e-12);
  EXPECT_NEAR(sensor.points[2].z, -0.035, 1e-12);
}

TEST(Ks21, TeamColourIsOnTrunkAndUpperArmsAndTouchesNothing) {
  int marks = 0;
  for (const Body& b : ks21().tree.bodies) {
    for (const BodyShape& s : b.shapes) {
      if (!s.team_colour) continue;
      ++marks;
      EXPECT_TRUE(b.name == "trunk" || b.name.starts_with("upper_arm")) << b.name;
      EXPECT_TRUE(s.drawn && !s.collides);
    }
  }
  EXPECT_EQ(marks, 4);
}

}  // namespace
}  // namespace murosimf
