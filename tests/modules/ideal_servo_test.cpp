// Servos that do as they are told, as far as their range and speed allow.

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/motion_world.h"

namespace murosimf::motion {
namespace {

constexpr int kWaist = 0;  // -90 to 90 degrees, 7.12 rad/s

struct Joint {
  MotionWorld motion{0.01};
  ObjectId robot;
  Handle<ServoCommand> commands;
  Joint() : robot(motion.add("robot", ks21(), std::vector<double>(21, 0.0))) {
    motion.link();
    commands = motion.linked().handle(robot, kJointCommand, subset::kJoints);
  }
  void run(const ServoCommand& command, int steps) {
    commands.set(command, kWaist);
    for (int i = 0; i < steps; ++i) motion.step();
  }
  double position() const { return motion.get(robot, kJointPosition, subset::kJoints, kWaist); }
  double velocity() const { return motion.get(robot, kJointVelocity, subset::kJoints, kWaist); }
};

TEST(IdealServo, RunsAtItsNoLoadSpeedAndStopsWhereItShould) {
  book::Page page({book::Chapter::kServos,
                   "An ideal servo runs at its no-load speed and stops where it should",
                   R"(q = \min(q_d, \; \omega_0 t))",
                   "Definition",
                   {{"\\omega_0", "no-load speed, here 7.12", "rad/s"}, {"q_d", "command, here 1", "rad"}},
                   {"time $t$", "s"},
                   {"angle $q$", "rad"}});
  const auto angle = [](double t) { return min(1.0, 7.12 * t); };
  page.curve(0, 0.2, angle);
  Joint joint;
  for (int i = 1; i <= 10; ++i) {
    joint.run({1.0, 0, 0, 30, 0}, 1);
    EXPECT_TRUE(page.near(0.01 * i, joint.position(), angle(0.01 * i), 1e-12));
  }
  EXPECT_NEAR(joint.velocity(), 7.12, 1e-12);
  joint.run({1.0, 0, 0, 30, 0}, 10);
  EXPECT_TRUE(page.near(0.2, joint.position(), angle(0.2), 1e-12));
  EXPECT_EQ(joint.position(), 1.0);
  EXPECT_EQ(joint.velocity(), 0.0);
}

TEST(IdealServo, ObeysASpeedLimitBelowItsOwnOnly) {
  Joint slow, fast;
  slow.run({-1.0, 0.5, 0, 30, 0}, 10);
  EXPECT_NEAR(slow.position(), -0.05, 1e-12);
  fast.run({-1.0, 50, 0, 30, 0}, 10);
  EXPECT_NEAR(fast.position(), -0.712, 1e-12);
}

TEST(IdealServo, StaysWithinItsRange) {
  Joint joint;
  joint.run({1e300, 0, 0, 30, 0}, 100);
  EXPECT_NEAR(joint.position(), kPi / 2, 1e-9);
  joint.run({-1e300, 0, 0, 30, 0}, 100);
  EXPECT_NEAR(joint.position(), -kPi / 2, 1e-9);
}

TEST(IdealServo, WithoutStiffnessItHoldsTheRateOfTheCommandWithinSpeedAndRange) {
  Joint joint;
  joint.run({0, -0.5, 0, 0, 0.05}, 10);
  EXPECT_NEAR(joint.position(), -0.05, 1e-12);
  EXPECT_NEAR(joint.velocity(), -0.5, 1e-12);
  joint.run({0, 50, 0, 0, 0.05}, 10);
  EXPECT_NEAR(joint.position(), -0.05 + 0.712, 1e-12);
  joint.run({0, 50, 0, 0, 0.05}, 100);
  EXPECT_NEAR(joint.position(), kPi / 2, 1e-9);
  EXPECT_NEAR(joint.velocity(), 0, 1e-9);
}

TEST(IdealServo, WithoutGainItKeepsItsPosition) {
  Joint joint;
  joint.run({0.3, 0, 0, 30, 0}, 20);
  joint.run({1.0, 0, 0, 0, 0}, 20);
  EXPECT_EQ(joint.position(), 0.3);
}

}  // namespace
}  // namespace murosimf::motion
