// Control software of robots on wheels: drives, plans, and ways around what a laser sees.

#include "cart/cart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::cart {
namespace {

client::RobotDescription onWheels(int wheels, bool rollers, double roller_angle = 0) {
  client::RobotDescription robot;
  robot.model = "toy";
  for (int i = 0; i < wheels; ++i) {
    robot.joints.push_back({"drive", -1e9, 1e9, 30, 1});
    client::WheelDescription& wheel = robot.wheels.emplace_back();
    wheel.joint = i, wheel.radius = 0.05, wheel.rollers = rollers;
    const SinCos<double> a = sincos(kPi / 3 + 2 * kPi * i / wheels);
    wheel.centre = rollers ? Vector3{0.1 * a.cos, 0.1 * a.sin, 0.05} : Vector3{0, i == 0 ? 0.1 : -0.1, 0.05};
    wheel.axle = rollers ? Vector3{a.cos, a.sin, 0} : Vector3{0, 1, 0};
    wheel.roller_angle = roller_angle;
  }
  return robot;
}

/// Four mecanum wheels at the corners of a rectangle.
client::RobotDescription mecanum() {
  client::RobotDescription robot = onWheels(4, true);
  for (int i = 0; i < 4; ++i) {
    client::WheelDescription& wheel = robot.wheels[static_cast<std::size_t>(i)];
    const double x = i < 2 ? 0.12 : -0.12, y = i % 2 == 0 ? 0.1 : -0.1;
    wheel.centre = {x, y, 0.05}, wheel.axle = {0, 1, 0};
    wheel.roller_angle = x * y > 0 ? -kPi / 4 : kPi / 4;
  }
  return robot;
}

/// The way that a drive sees when its wheels do for a second what it commanded.
BaseMotion seen(const WheelDrive& drive, const BaseMotion& velocity, std::size_t joints) {
  std::vector<client::JointCommand> commands(joints);
  drive.command(velocity, commands);
  std::vector<client::JointReading> readings(joints);
  std::vector<double> last(drive.wheelCount());
  for (std::size_t i = 0; i < joints; ++i) readings[i].position = commands[i].velocity;
  return drive.wayOf(readings, last);
}

TEST(CartDrive, OdometryUndoesWhatIsCommanded) {
  const BaseMotion wanted{0.2, -0.1, 0.5};
  for (const client::RobotDescription& robot : {onWheels(3, true), onWheels(3, true, 0.4), mecanum()}) {
    const WheelDrive drive(robot);
    EXPECT_TRUE(drive.omnidirectional());
    const BaseMotion way = seen(drive, wanted, robot.joints.size());
    EXPECT_NEAR(way.x, wanted.x, 1e-12);
    EXPECT_NEAR(way.y, wanted.y, 1e-12);
    EXPECT_NEAR(way.turn, wanted.turn, 1e-12);
  }
  const WheelDrive tyres(onWheels(2, false));
  EXPECT_FALSE(tyres.omnidirectional());
  const BaseMotion way = seen(tyres, {0.2, 0, 0.5}, 2);
  EXPECT_NEAR(way.x, 0.2, 1e-12);
  EXPECT_NEAR(way.y, 0, 1e-12);
  EXPECT_NEAR(way.turn, 0.5, 1e-12);
}

TEST(CartDrive, TwoTyresTurnAsTheTextbookSays) {
  std::vector<client::JointCommand> commands(2);
  WheelDrive(onWheels(2, false)).command({0.3, 0, 1}, commands);
  EXPECT_NEAR(commands[0].velocity, (0.3 - 1 * 0.1) / 0.05, 1e-12);  // left: v - w b/2
  EXPECT_NEAR(commands[1].velocity, (0.3 + 1 * 0.1) / 0.05, 1e-12);
  EXPECT_EQ(commands[0].kp, 0);
  EXPECT_GT(commands[0].kd, 0);
}

TEST(CartDrive, SlowsDownAsAWholeWhereAWheelWouldTurnTooFast) {
  std::vector<client::JointCommand> commands(2);
  WheelDrive(onWheels(2, false)).command({3, 0, 5}, commands);
  EXPECT_NEAR(commands[1].velocity, 30, 1e-12);
  EXPECT_NEAR(commands[0].velocity / commands[1].velocity, 2.5 / 3.5, 1e-12);
}

TEST(CartDrive, RefusesWheelsThatCannotDriveIt) {
  EXPECT_THROW(WheelDrive{client::RobotDescription{}}, std::invalid_argument);
  EXPECT_THROW(WheelDrive{onWheels(2, true)}, std::invalid_argument);
}

TEST(CartPlan, ReadsRolesAndRefusesWhatIsNone) {
  EXPECT_EQ(readCartPlan("").task, CartTask::kPlay);
  EXPECT_EQ(readCartPlan("keeper").task, CartTask::kPlay);
  EXPECT_EQ(readCartPlan("rest").task, CartTask::kRest);
  const CartPlan square = readCartPlan("square 1.5  0.2");
  EXPECT_EQ(square.task, CartTask::kSquare);
  EXPECT_EQ(square.edge, 1.5);
  EXPECT_EQ(square.speed, 0.2);
  EXPECT_EQ(readCartPlan("drive 0.1 -0.2 0.3").velocity.y, -0.2);
  for (const char* wrong : {"square x", "square 0", "square 1 2 3 4", "drive 1 2", "drive 1 2 3m", "square -1 0.3"})
    EXPECT_THROW(readCartPlan(wrong), std::invalid_argument) << wrong;
}

/// A guard that sees a wall of points before it, from y = low to high at x = distance.
LaserGuard before(double distance, double low, double high) {
  client::RangeSensorDescription sensor;
  std::vector<double> ranges;
  for (int i = -90; i <= 90; ++i) {
    const double angle = i * kPi / 180, y = distance * std::tan(angle);
    sensor.angles.push_back(angle);
    const bool hit = std::abs(i) < 89 && y >= low && y <= high;
    ranges.push_back(hit ? distance / std::cos(angle) : std::numeric_limits<double>::infinity());
  }
  LaserGuard guard(0.2);
  guard.describe({{sensor}});
  const client::RangeScan scan{0, 0, ranges};
  guard.see({&scan, 1});
  return guard;
}

TEST(LaserGuard, AWallLeavesItsDistanceLessTheRobotsRadius) {
  const LaserGuard guard = before(1, -1, 1);
  EXPECT_NEAR(guard.freeWay(0, 3), 0.8, 0.01);
  EXPECT_NEAR(guard.freeWay(kPi, 3), 3, 0);
}

TEST(LaserGuard, GoesAroundOnTheSideThatIsNearer) {
  const LaserGuard left_free = before(0.6, -1, 0.1), right_free = before(0.6, -0.1, 1);
  EXPECT_GT(left_free.wayAround(0, 0.55), 0.2);
  EXPECT_LT(right_free.wayAround(0, 0.55), -0.2);
  EXPECT_EQ(before(2, -1, 1).wayAround(0.1, 0.5), 0.1);
}

TEST(LaserGuard, TheBallIsNothingToGoAround) {
  LaserGuard guard = before(0.5, -0.05, 0.05);
  EXPECT_LT(guard.freeWay(0, 2), 0.4);
  guard.forgive(GroundPoint{0.55, 0}, 0.15);
  EXPECT_EQ(guard.freeWay(0, 2), 2);
}

}  // namespace
}  // namespace murosimf::controllers::cart
