// Servos that follow their commands whatever the load.

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "modules/dynamic_world.h"
#include "murosimf/modules/actuation/tracking_servo.h"
#include "murosimf/robot/tree_builder.h"

namespace murosimf::motion {
namespace {

constexpr double kGain = 20, kDrag = 0.4, kFastest = 5;  // SI

/// A base with a joint that turns and one that slides.
const RobotBlueprint& crane() {
  static const RobotBlueprint print = [] {
    TreeBuilder builder;
    const MassProperties mass = boxMass(1, {0.1, 0.1, 0.1}, {});
    const ServoParameters servo{"test", 1, kFastest, kGain, kDrag, 0, 0};
    builder.base("base")
        .body({"base", mass})
        .revolute("slew", kAxisZ, {-1, 2, 100, 100}, servo)
        .body({"jib", mass})
        .prismatic("hoist", kAxisZ, {-1, 2, 100, 100}, servo)
        .body({"hook", mass});
    RobotModel model;
    model.name = "crane";
    model.tree = builder.build();
    RobotBlueprint made{std::move(model), {}};
    made.flat = flattenTree(made.model.tree);
    return made;
  }();
  return print;
}

class Crane {
 public:
  explicit Crane(const DynamicLevel& level, double step = 1e-3, int lanes = 1) : world_(step) {
    robot_ = world_.add("crane", crane(), {0, 0});
    world_.link(level, lanes);
  }
  void command(const ServoCommand& command) {
    for (int j = 0; j < 2; ++j) world_.linked().handle(robot_, kJointCommand, subset::kJoints).set(command, j);
  }
  void run(double seconds) { world_.run(seconds); }
  double q(int j) { return world_.get(robot_, kJointPosition, subset::kJoints, j); }
  double dq(int j) { return world_.get(robot_, kJointVelocity, subset::kJoints, j); }

 private:
  DynamicWorld world_;
  ObjectId robot_;
};

const DynamicLevel kUnlimited = simplified("").with("tracking_servo.largest_acceleration", 0);
const DynamicLevel kAtOnce = kUnlimited.with("tracking_servo.lag", 0);

TEST(TrackingServo, ReachesItsCommandInOneStepOrAtTheLargestSpeed) {
  Crane crane(kAtOnce);
  crane.command({0.004, 0, 0, 1, 0});
  crane.run(1e-3);
  for (int j = 0; j < 2; ++j) {
    EXPECT_NEAR(crane.q(j), 0.004, 1e-17);
    EXPECT_NEAR(crane.dq(j), 4, 1e-12);
  }
  crane.command({1, 0, 0, 1, 0});
  crane.run(0.1);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.q(j), 0.004 + kFastest * 0.1, 1e-12);
  crane.command({1, 2, 0, 1, 0});  // the command's own limit
  crane.run(0.1);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.dq(j), 2, 1e-12);
}

TEST(TrackingServo, StaysWithinItsRangeAndWhereItIsWithoutGain) {
  Crane crane(kAtOnce);
  crane.command({3, 0, 0, 1, 0});
  crane.run(1);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.q(j), 2, 1e-12);
  crane.command({0, 0, 0, 0, 0});
  crane.run(1);
  for (int j = 0; j < 2; ++j) {
    EXPECT_NEAR(crane.q(j), 2, 1e-12);
    EXPECT_NEAR(crane.dq(j), 0, 1e-9);
  }
}

TEST(TrackingServo, WithoutStiffnessItHoldsTheRateOfTheCommandWithinItsRange) {
  Crane crane(kAtOnce);
  crane.command({0, -1.5, 0, 0, 0.05});
  crane.run(0.5);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.dq(j), -1.5, 1e-12);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.q(j), -0.75, 1e-9);
  crane.command({0, 3, 0, 0, 0.05});
  crane.run(2);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.q(j), 2, 1e-9);
}

TEST(TrackingServo, ComesNearItsCommandWithTheLagOfItsGains) {
  Crane crane(kUnlimited, 1e-4);
  book::Page page({book::Chapter::kServos,
                   "A servo of simplified dynamics comes near its command with the lag of its gains",
                   R"(q = q_d \left( 1 - e^{-t k_p / k_d} \right))",
                   "Balance of spring and damping where inertia does not count",
                   {{"k_p, k_d", "gains, here 20 and 0.4", "N m/rad, N m s/rad"}, {"q_d", "command, here 0.05", "rad"}},
                   {"time $t$", "s"},
                   {"position $q$", "rad, m"}});
  const double lag = kDrag / kGain;
  const auto position = [&](double t) { return 0.05 * (1 - std::exp(-t / lag)); };
  crane.command({0.05, 0, 0, 1, 0});
  for (int i = 1; i <= 10; ++i) {
    crane.run(0.01);
    for (int j = 0; j < 2; ++j) {
      page.series(j == 0 ? "turns" : "slides").curve(0, 0.1, position);
      EXPECT_TRUE(page.near(0.01 * i, crane.q(j), position(0.01 * i), 1e-4));
    }
  }
}

TEST(TrackingServo, AccelerationThatAJointNamesItselfGoesBeforeThatOfAll) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("crane", crane(), {0, 0});
  world.world().set(world.world().members(robot, subset::kJoints)[0], kLargestAcceleration, 40.0);
  world.link(kAtOnce.with("tracking_servo.largest_acceleration", 20));
  for (int j = 0; j < 2; ++j) world.linked().handle(robot, kJointCommand, subset::kJoints).set({1, 0, 0, 1, 0}, j);
  world.run(0.05);
  EXPECT_NEAR(world.get(robot, kJointVelocity, subset::kJoints, 0), 40 * 0.05, 1e-9);
  EXPECT_NEAR(world.get(robot, kJointVelocity, subset::kJoints, 1), 20 * 0.05, 1e-9);
}

TEST(TrackingServo, AcceleratesAndBrakesAsGentlyAsItIsTold) {
  constexpr double kLargest = 20, kWay = 0.8;
  Crane crane(kAtOnce.with("tracking_servo.largest_acceleration", kLargest));
  crane.command({kWay, 0, 0, 1, 0});
  const double half = std::sqrt(kWay / kLargest);  // half the way with +a, half with -a, in twice this time
  crane.run(half);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.q(j), kWay / 2, 5e-3);
  double most = 0, last = crane.dq(0);
  for (int i = 0; i < 300; ++i) {
    crane.run(1e-3);
    EXPECT_LE(std::fabs(crane.dq(0) - last), kLargest * 1e-3 * (1 + 1e-9));
    last = crane.dq(0), most = std::max(most, crane.q(0));
  }
  EXPECT_LT(most, kWay + 1e-9);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(crane.q(j), kWay, 1e-6);
}

TEST(TrackingServo, LanesEqualScalarBitForBit) {
  const DynamicLevel level = simplified("").with("tracking_servo.largest_acceleration", 50);
  Crane scalar(level), four(level, 1e-3, 4), eight(level, 1e-3, 8);
  for (Crane* crane : {&scalar, &four, &eight}) {
    crane->command({0.7, 3, 0, 1, 0});
    crane->run(0.123);
  }
  for (int j = 0; j < 2; ++j) {
    EXPECT_EQ(four.q(j), scalar.q(j));
    EXPECT_EQ(eight.q(j), scalar.q(j));
    EXPECT_EQ(eight.dq(j), scalar.dq(j));
    EXPECT_GT(scalar.q(j), 0.01);
  }
}

}  // namespace
}  // namespace murosimf::motion
