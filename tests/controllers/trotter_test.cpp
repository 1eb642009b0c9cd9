// The trot of a four-legged robot, without any dynamics.

#include "trotter/trotter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "murosimf/math/rotation.h"
#include "trotter/rappe_leg.h"

namespace murosimf::controllers::trotter {
namespace {

constexpr double kDegree = kPi / 180;

RC_GTEST_PROP(TrotterLeg, InverseUndoesForwardKinematics, ()) {
  const auto draw = [](int low, int high) { return kDegree * 0.001 * *rc::gen::inRange(1000 * low, 1000 * high); };
  const auto leg = *rc::gen::inRange<std::size_t>(0, kLegCount);
  const double knee = draw(-135, -25);
  const LegAngles q{draw(-40, 40), draw(-40, 40) - 0.5 * knee, knee};  // the hoof is below the hip
  const LegSolution found = solveLeg(hoofPlace(q, leg), leg);
  RC_ASSERT(found.within_reach);
  for (std::size_t i = 0; i < kLegJoints; ++i) RC_ASSERT(std::abs(found.angles[i] - q[i]) < 1e-9);
}

TEST(TrotterLeg, StretchesTowardsWhatItCannotReach) {
  const LegSolution leg = solveLeg({0.1, -kHipOffset, -0.6}, 0);
  EXPECT_FALSE(leg.within_reach);
  const Vector3 p = hoofPlace(leg.angles, 0);
  EXPECT_NEAR(atan2(p.x, -p.z), atan2(0.1, 0.6), 1e-9);
}

Vector3 hoofOf(const JointAngles& q, std::size_t leg) {
  const Vector3 hip{endSign(leg) * kHipForward, sideSign(leg) * kHipAside, 0};
  return hip + hoofPlace({q[3 * leg], q[3 * leg + 1], q[3 * leg + 2]}, leg);
}

TEST(Trot, StandingHoovesMoveWithTheGroundAndTheOthersAreLifted) {
  const TrotParameters trot;
  const TrotCommand v{0.4, -0.1, 0.7};
  constexpr double kStep = 1e-6;
  for (double phase = 0.003; phase < 1; phase += 0.01) {
    const JointAngles now = trotPose(trot, phase, 1, v, {}), next = trotPose(trot, phase + kStep, 1, v, {});
    int standing = 0;
    for (std::size_t leg = 0; leg < kLegCount; ++leg) {
      const Vector3 p = hoofOf(now, leg);
      if (legCycle(trot, phase, leg).zeta > 0) {
        EXPECT_GT(p.z, -trot.hip_height);
        continue;
      }
      ++standing;
      const Vector3 speed = (hoofOf(next, leg) - p) * (1 / (kStep * trot.period));
      EXPECT_LT(norm(speed - Vector3{-v.vx + v.omega * p.y, -v.vy - v.omega * p.x, 0}), 1e-5) << phase << " " << leg;
      EXPECT_NEAR(p.z, -trot.hip_height, 1e-12);
    }
    EXPECT_TRUE(standing == 2 || standing == 4) << phase;
  }
}

TEST(Trot, HoovesMeetTheGroundWithItsSpeed) {
  const TrotParameters trot;
  const double swing = 0.5 * (1 - trot.double_support);
  constexpr double kStep = 1e-6;
  for (const double phase : {kStep, swing - kStep}) {  // of leg 0 just after leaving, just before meeting the ground
    const double slope = (legCycle(trot, phase + kStep / 2, 0).tau - legCycle(trot, phase - kStep / 2, 0).tau) / kStep;
    EXPECT_NEAR(slope, trot.period, 1e-4 * trot.period);
  }
  EXPECT_NEAR(legCycle(trot, swing - 1e-9, 0).tau, legCycle(trot, swing + 1e-9, 0).tau, 1e-8);
}

TEST(Trot, LegsOnTheLowSideOfALeaningTrunkPushMore) {
  const JointAngles level = trotPose({}, 0, 0, {}, {}), nose_down = trotPose({}, 0, 0, {}, {.pitch = 0.1});
  const JointAngles right_down = trotPose({}, 0, 0, {}, {.roll = 0.1});
  for (std::size_t leg = 0; leg < kLegCount; ++leg) {
    EXPECT_GT(endSign(leg) * (hoofOf(level, leg).z - hoofOf(nose_down, leg).z), 1e-3) << leg;
    EXPECT_LT(sideSign(leg) * (hoofOf(level, leg).z - hoofOf(right_down, leg).z), -1e-3) << leg;
  }
}

TEST(Attitude, FollowsTheGyroscopeAndFindsTheVerticalByTheAccelerometer) {
  Attitude turned;
  for (int i = 0; i < 100; ++i) turned.observe(0.01, {0.3, 0, 0}, {});
  EXPECT_NEAR(turned.roll(), 0.3, 1e-3);
  Attitude drawn;
  const Vector3 up = applyTransposed(rotationY(0.2) * rotationX(-0.1), Vector3{0, 0, 9.81});
  for (int i = 0; i < 2000; ++i) drawn.observe(0.01, {}, up);
  EXPECT_NEAR(drawn.pitch(), 0.2, 1e-4);
  EXPECT_NEAR(drawn.roll(), -0.1, 1e-4);
}

TEST(TrotPlan, OrdersHoldFromTheirTimesOn) {
  const std::vector<TrotOrder> plan = readTrotPlan("0.4 0 -.1, 0 0.1 0@2.5 ,0 0 0 @ 4");
  ASSERT_EQ(plan.size(), 3u);
  EXPECT_EQ(orderAt(plan, 0), (TrotCommand{0.4, 0, -0.1}));
  EXPECT_EQ(orderAt(plan, 2.6), (TrotCommand{0, 0.1, 0}));
  EXPECT_EQ(orderAt(plan, 9), TrotCommand{});
  EXPECT_EQ(orderAt(readTrotPlan("1 0 0@3"), 2), TrotCommand{});
  EXPECT_TRUE(readTrotPlan("").empty());
}

TEST(TrotPlan, WhatIsNoPlanIsRefused) {
  for (const char* text : {"fast", "0.4 0", "0.4 0 0 7", "0.4 0 0@", "0.4 0 0, 0 0 0", "0.4 0 0,", "0.4 0 nan",
                           "0 0 0@2, 0 0 0@1", "0.4,0,0"}) {
    EXPECT_THROW(readTrotPlan(text), std::invalid_argument) << text;
  }
}

client::RobotDescription description(const std::string& role) {
  client::RobotDescription robot;
  robot.model = "rappe", robot.role = role;
  for (const std::string_view name : kJointNames) robot.joints.emplace_back().name = name;
  return robot;
}

TEST(Trotter, RefusesOtherRobots) {
  client::RobotDescription robot = description("");
  robot.joints[2].name = "knee";
  EXPECT_THROW(Trotter().start(robot), std::invalid_argument);
  robot.joints.pop_back();
  EXPECT_THROW(Trotter().start(robot), std::invalid_argument);
}

TEST(Trotter, GoesOnFromASavedStateAsIfNothingHadBeen) {
  Trotter first, second;
  first.start(description("0.3 0 0.2")), second.start(description("0.3 0 0.2"));
  client::CommandFrame a, b;
  a.joints.resize(kJointCount), b.joints.resize(kJointCount);
  const auto step = [](Trotter& trotter, int i, client::CommandFrame& commands) {
    client::SensorFrame felt;
    felt.time = 0.01 * i, felt.angular_velocity = {0.1, -0.2, 0.05}, felt.specific_force = {0.1, 0, 9.8};
    trotter.step(felt, commands);
  };
  for (int i = 0; i < 200; ++i) step(first, i, a);
  StateArchive saved;
  first.archive(saved);
  StateArchive loaded(saved.bytes());
  second.archive(loaded);
  EXPECT_TRUE(loaded.exhausted());
  for (int i = 200; i < 300; ++i) {
    step(first, i, a), step(second, i, b);
    for (std::size_t j = 0; j < kJointCount; ++j) {
      ASSERT_EQ(a.joints[j].position, b.joints[j].position) << i;
      ASSERT_EQ(a.joints[j].velocity, b.joints[j].velocity) << i;
    }
  }
}

}  // namespace
}  // namespace murosimf::controllers::trotter
