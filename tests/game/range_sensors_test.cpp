// Laser scanners, distance sensors and bumpers of robots on wheels, in worlds that are built from scenarios.

#include <limits>

#include "game/wheeled_robot.h"
#include "murosimf/soccer/field.h"

namespace murosimf::test {
namespace {

constexpr int kLaser = 0, kInfraredLeft = 1, kUltrasound = 3;
constexpr double kNever = std::numeric_limits<double>::infinity();

const std::string kPerfect =
    "[robots.red.1.properties]\n\"laser.range_noise\" = 0\n\"laser.range_noise_share\" = 0\n"
    "\"infrared_left.range_noise_share\" = 0\n\"ultrasound.range_noise\" = 0\n\"ultrasound.range_quantum\" = 0\n";

/// A second robot, which stands still.
std::string mate(const std::string& file, const std::string& pose, const std::string& level = "kinematic") {
  return fmt::format("[robots.blue.1]\nfile = \"robots/{}.urdf\"\npose = {}\nlevel = \"{}\"\n", file, pose, level);
}

/// A robot and a ball, before it and a little to its left.
std::string withBall(const std::string& more = "") {
  std::string text = wheeled("duo", more);
  const std::string none = "[ball]\npresent = false\n";
  return text.replace(text.find(none), none.size(), "[ball]\nposition = [1, 0.1]\n");
}

TEST(LaserScanner, SeesABallAsTheCircleAtItsHeight) {
  WheeledRobot duo(withBall(kPerfect));
  duo.run(0.2);
  const client::RangeSensorDescription& laser = duo.wires->description.range_sensors.at(kLaser);
  const std::vector<double>& ranges = duo.wires->scans.at(kLaser);
  ASSERT_EQ(ranges.size(), 181U);
  ASSERT_EQ(laser.angles.size(), 181U);
  const Pose X_WL = duo.base() * laser.X_BS;
  const ObjectId ball = duo.simulation->world().find("ball");
  const Vector3 p = inverse(X_WL) * duo.simulation->linked().handle(ball, kBasePose).get().translation;
  const double radius = std::sqrt(0.07 * 0.07 - p.z * p.z);
  int hits = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double along = p.x * std::cos(laser.angles[i]) + p.y * std::sin(laser.angles[i]);
    const double beside = p.y * std::cos(laser.angles[i]) - p.x * std::sin(laser.angles[i]);
    if (along < 0 || std::fabs(beside) > radius) continue;
    ++hits;
    EXPECT_NEAR(ranges[i], along - std::sqrt(radius * radius - beside * beside), 1e-6);
  }
  EXPECT_GE(hits, 4);
}

TEST(LaserScanner, SeesAnotherRobotAndNotItself) {
  WheeledRobot duo(wheeled("duo", kPerfect + mate("ks21", "[0.8, 0, 0]")));
  duo.run(0.2);
  const std::vector<double>& ranges = duo.wires->scans.at(kLaser);
  double nearest = kNever;
  for (const double range : ranges) nearest = std::min(nearest, range);
  EXPECT_GT(nearest, 0.5);
  EXPECT_LT(nearest, 0.8);
  EXPECT_EQ(ranges.front(), kNever);
}

TEST(LaserScanner, ScansAtItsPeriodAndTellsWhen) {
  WheeledRobot duo(wheeled("duo", "[robots.red.1.properties]\n\"laser.range_period\" = 0.1\n"));
  duo.run(1.0);
  EXPECT_NEAR(duo.wires->scan_times.at(kLaser), 1.0, 0.1 + 1e-9);
  EXPECT_NEAR(std::remainder(duo.wires->scan_times.at(kLaser), 0.1), 0, 1e-9);
  EXPECT_NEAR(duo.wires->description.range_sensors.at(kLaser).period, 0.1, 0);
}

TEST(LaserScanner, NoiseHasTheDeviationThatIsAskedFor) {
  // All rays within a wall's reach would differ; a ball far away does not: one ray, many scans.
  const std::string text = withBall(
      "[robots.red.1.properties]\n\"laser.range_noise\" = 0.01\n"
      "\"laser.range_noise_share\" = 0\n\"laser.range_offset\" = 0.05\n");
  WheeledRobot noisy(text), exact(withBall(kPerfect));
  exact.run(0.2);
  const std::vector<double> truth = exact.wires->scans.at(kLaser);
  double sum = 0, square = 0, count = 0;
  for (int i = 0; i < 200; ++i) {
    noisy.run(0.05);
    const std::vector<double>& ranges = noisy.wires->scans.at(kLaser);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      if (!std::isfinite(ranges[k]) || truth[k] > 2) continue;
      const double error = ranges[k] - truth[k];
      sum += error, square += error * error, count += 1;
    }
  }
  ASSERT_GT(count, 800);
  const double mean = sum / count;
  EXPECT_NEAR(mean, 0.05, 4 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(square / count - mean * mean), 0.01, 0.05 * 0.01);
}

TEST(LaserScanner, ADelayedScanArrivesLaterWithItsOwnTime) {
  WheeledRobot duo(wheeled("duo", "[robots.red.1.properties]\n\"laser.range_delay\" = 0.12\n"));
  duo.run(0.55);
  EXPECT_LE(duo.wires->scan_times.at(kLaser), 0.55 - 0.12 + 1e-9);
  EXPECT_GE(duo.wires->scan_times.at(kLaser), 0.55 - 0.12 - 0.05 - 1e-9);
}

TEST(DistanceSensor, TellsTheNearestThingInItsCone) {
  // Behind duo a robot on wheels, beside it nothing.
  WheeledRobot duo(wheeled("duo", kPerfect + mate("trio", "[-1, 0.05, 0]")));
  duo.run(0.2);
  EXPECT_EQ(duo.wires->scans.at(kInfraredLeft).size(), 1U);
  EXPECT_EQ(duo.wires->scans.at(kInfraredLeft).front(), kNever);
  const double range = duo.wires->scans.at(kUltrasound).front();
  EXPECT_GT(range, 0.6);
  EXPECT_LT(range, 0.86);
}

TEST(DistanceSensor, WhatIsNearerThanItsLeastIsTold) {
  WheeledRobot duo(wheeled("duo", kPerfect + mate("trio", "[-0.31, 0, {deg = 180}]")));
  duo.run(0.2);
  EXPECT_EQ(duo.wires->scans.at(kUltrasound).front(), -kNever);
}

class Bumper : public testing::TestWithParam<const char*> {};

TEST_P(Bumper, ClosesWhereABallIsPushedAndNotBefore) {
  WheeledRobot duo(withBall(fmt::format("level = \"{}\"\n", GetParam())));
  duo.turn({5, 5});
  duo.run(1);
  ASSERT_EQ(duo.wires->touches.size(), 2U);
  EXPECT_EQ(duo.wires->touches[0], 0);
  bool front = false;
  for (int i = 0; i < 400; ++i) {
    duo.run(0.01);
    front = front || duo.wires->touches[0] == 1;
    EXPECT_EQ(duo.wires->touches[1], 0);
  }
  EXPECT_TRUE(front);
  const ObjectId ball = duo.simulation->world().find("ball");
  EXPECT_GT(duo.simulation->linked().handle(ball, kBasePose).get().translation.x, 1.1);
}

TEST_P(Bumper, FeelsAnotherRobot) {
  for (const std::string other : {"kinematic", "fast"}) {
    WheeledRobot duo(wheeled("duo", fmt::format("level = \"{}\"\n", GetParam()) + mate("trio", "[0.8, 0, 0]", other)));
    duo.turn({5, 5});
    bool front = false;
    for (int i = 0; i < 400; ++i) {
      duo.run(0.01);
      front = front || duo.wires->touches[0] == 1;
    }
    EXPECT_TRUE(front) << other;
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, Bumper, testing::Values("kinematic", "fast"),
                         [](const auto& test) { return std::string(test.param); });

TEST(RangeSensor, ANumberThatCannotBeIsToldWithItsPlace) {
  BuiltWorld built(wheeled("duo", "properties = {\"laser.range_noise\" = -1}\n", "[0, 0, 0]"),
                   {"robots.red.1.control=none"});
  bool told = false;
  for (const std::string& words : built.complaints())
    told = told || words.find("range_noise of robots.red.1.laser is -1; expected a number from 0 to 100 m") !=
                       std::string::npos;
  EXPECT_TRUE(told);
}

TEST(Descriptions, TellOfWheelsRangeSensorsAndBumpers) {
  WheeledRobot trio(wheeled("trio"));
  trio.run(0.02);
  const client::RobotDescription& d = trio.wires->description;
  ASSERT_EQ(d.wheels.size(), 3U);
  EXPECT_EQ(d.wheels[0].joint, 0);
  EXPECT_TRUE(d.wheels[0].rollers);
  EXPECT_NEAR(d.wheels[0].radius, 0.04, 1e-12);
  EXPECT_NEAR(d.wheels[0].centre.x, 0.0575, 1e-9);
  EXPECT_NEAR(d.wheels[0].axle.x, 0.5, 1e-9);
  ASSERT_EQ(d.range_sensors.size(), 4U);
  EXPECT_EQ(d.range_sensors[kUltrasound].angles.size(), 1U);
  EXPECT_NEAR(d.range_sensors[kUltrasound].half_angle, 0.2, 1e-12);
  ASSERT_EQ(d.touch_mounts.size(), 2U);
  EXPECT_EQ(d.touch_mounts[0].name, "bumper_front_switch");
  EXPECT_GT(d.touch_mounts[0].centre.x, 0.1);
}

}  // namespace
}  // namespace murosimf::test
