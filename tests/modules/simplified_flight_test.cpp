// Simplified dynamics in free flight: what momentum says, exactly.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "book/page.h"
#include "modules/dynamic_world.h"
#include "modules/stilt_walker.h"
#include "modules/tree_momentum.h"
#include "murosimf/linking/robot_module.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81;

/// Gives a robot a pose and a velocity, in its own axes.
void toss(DynamicWorld& world, ObjectId robot, const Pose& X_WB, const SpatialMotion<double>& V_B) {
  world.linked().handle(robot, kBasePose).set(X_WB);
  world.linked().handle(robot, kBaseVelocity).set(V_B);
}
const Pose kTossed{rotationX(0.3) * rotationY(-0.5) * rotationZ(1.0), {0.1, -0.2, 2}};
const SpatialMotion<double> kSpin{{1.5, -2, 0.7}, {0.4, 0.3, 1.1}};

/// Swings all joints, each in its own rhythm.
void swing(DynamicWorld& world, ObjectId robot, double amplitude) {
  std::vector<double> q;
  const int joints = static_cast<int>(world.world().members(robot, subset::kJoints).size());
  for (int j = 0; j < joints; ++j) q.push_back(amplitude * std::sin(3 * (1 + 0.1 * j) * world.time() + j));
  world.command(robot, q);
}

TEST(SimplifiedFlight, RobotThatHoldsStillFallsWithoutTurning) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), gait(0, {}, 0));
  world.link(simplified(""));
  toss(world, robot, kTossed, {{}, applyTransposed(kTossed.rotation, Vector3{0.4, 0.3, 1.1})});
  world.run(1);
  EXPECT_LT(norm(world.base(robot).translation - kTossed.translation - Vector3{0.4, 0.3, 1.1 - kG / 2}), 1e-12);
  EXPECT_LT(norm(rotationLog(transposed(kTossed.rotation) * world.base(robot).rotation)), 1e-12);
}

TEST(SimplifiedFlight, MomentumStaysWhileAllLimbsSwing) {
  for (const RobotBlueprint* print : {&ks21(), &stiltWalker()}) {  // revolute and prismatic joints
    DynamicWorld world(1e-3);
    const ObjectId robot = world.add("robot", *print, std::vector<double>(print->model.tree.joints.size(), 0.0));
    world.link(simplified(""));
    toss(world, robot, kTossed, kSpin);
    const Momentum before = momentumOf(world.world(), world.linked(), robot);
    while (world.time() < 1) swing(world, robot, print == &ks21() ? 0.5 : 0.1), world.step();
    const Momentum after = momentumOf(world.world(), world.linked(), robot);
    const Vector3 parabola = before.centre + before.linear * (1 / before.mass) + Vector3{0, 0, -kG / 2};
    EXPECT_LT(norm(after.centre - parabola), 1e-12) << print->model.name;
    EXPECT_LT(norm(after.linear - before.linear - Vector3{0, 0, -kG * before.mass}), 1e-12 * norm(after.linear));
    EXPECT_LT(norm(after.angular - before.angular), 1e-12 * norm(before.angular)) << print->model.name;
  }
}

TEST(SimplifiedFlight, VersionOneKeepsTheMomentumOfOneRigidBody) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), gait(0, {}, 0));
  world.link(simplified("").with("simplified_dynamics.recompute", 0));
  toss(world, robot, kTossed, kSpin);
  const Momentum before = momentumOf(world.world(), world.linked(), robot);
  const Vector3 centre_B = applyInverse(kTossed, before.centre);
  while (world.time() < 1) swing(world, robot, 0.5), world.step();
  const Vector3 parabola = before.centre + before.linear * (1 / before.mass) + Vector3{0, 0, -kG / 2};
  EXPECT_LT(norm(world.base(robot) * centre_B - parabola), 1e-12);
}

/// A heavy wheel on a base, both symmetric about the axle.
RobotBlueprint flywheel(double base_inertia, double wheel_inertia) {
  TreeBuilder builder;
  const MassProperties base{2, {}, {0.01, 0.01, base_inertia, 0, 0, 0}};
  const MassProperties wheel{1, {}, {0.002, 0.002, wheel_inertia, 0, 0, 0}};
  builder.base("base")
      .body({"base", base})
      .translation({0, 0, 0.1})
      .revolute("axle", kAxisZ, {-4, 4, 50, 50})
      .body({"wheel", wheel});
  RobotModel model;
  model.name = "flywheel";
  model.tree = builder.build();
  RobotBlueprint print{std::move(model), {}};
  print.flat = flattenTree(print.model.tree);
  return print;
}

TEST(SimplifiedFlight, FlywheelTurnsItsBaseBackByTheRatioOfInertiasHoweverItTurns) {
  book::Page page({book::Chapter::kFlight,
                   "In simplified dynamics, too, a flywheel turns its base back by the ratio of inertias",
                   R"(\psi = -\frac{I_w}{I_b + I_w} q)",
                   "Angular momentum is kept, however fast the wheel turns",
                   {{"I_b, I_w", "inertia of base and wheel, here 0.015 and 0.003", "kg m^2"},
                    {"q", "turn of the wheel, here 2.5", "rad"}},
                   {"speed of the wheel", "rad/s"},
                   {"heading of the base $\\psi$", "rad"}});
  constexpr double kBase = 0.015, kWheel = 0.003, kTurn = 2.5;
  for (const double step : {1e-3, 1e-2}) {
    for (const double speed : {5.0, 23.0, 50.0}) {
      DynamicWorld world(step);
      const ObjectId robot = world.add("robot", flywheel(kBase, kWheel), {0});
      world.link(simplified(""));
      world.linked().handle(robot, kJointCommand, subset::kJoints).set({kTurn, speed, 0, 1, 0});
      world.run(1);
      page.series("step [s] =", step).curve(4, 51, [](double) { return -kWheel / (kBase + kWheel) * kTurn; });
      EXPECT_TRUE(page.near(speed, headingOf(world.base(robot)), -kWheel / (kBase + kWheel) * kTurn, 1e-12));
      EXPECT_NEAR(norm(world.get(robot, kBaseVelocity).w), 0, 1e-12);
    }
  }
}

/// A body with principal moments 1, 2, 3 that spins about the middle one, nearly.
double energyErrorOfTop(double step) {
  TreeBuilder builder;
  builder.base("base").body({"body", {1, {}, {1e-2, 2e-2, 3e-2, 0, 0, 0}}});
  RobotModel model;
  model.tree = builder.build();
  RobotBlueprint print{std::move(model), {}};
  print.flat = flattenTree(print.model.tree);
  DynamicWorld world(step);
  const ObjectId robot = world.add("top", print, {});
  world.link(simplified(""));
  toss(world, robot, {}, {{0.1, 10, 0.1}, {}});
  const auto spinEnergy = [&] {
    const Vector3 w = world.get(robot, kBaseVelocity).w;
    return 0.5e-2 * (w.x * w.x + 2 * w.y * w.y + 3 * w.z * w.z);
  };
  const double before = spinEnergy();
  double worst = 0;
  while (world.time() < 5) world.step(), worst = std::max(worst, std::fabs(spinEnergy() / before - 1));
  return worst;
}

TEST(SimplifiedFlight, TumblingBodyKeepsItsEnergyToTheSecondOrder) {
  const double coarse = energyErrorOfTop(2e-3), fine = energyErrorOfTop(1e-3);
  EXPECT_LT(fine, 1e-5);
  book::Page page({book::Chapter::kIntegrators,
                   "The midpoint rule of simplified dynamics keeps a tumbling body's energy to the second order",
                   R"(\log_2 \frac{\Delta E(2 h)}{\Delta E(h)} = 2)",
                   "[Hairer, Lubich, Wanner 2006]",
                   {{"\\Delta E", "largest share of the energy lost or gained in 5 s", ""}, {"h", "step", "s"}},
                   {"step $h$", "s"},
                   {"order found", ""}});
  EXPECT_TRUE(page.near(1e-3, std::log2(coarse / fine), 2, 0.25));
}

constexpr double kRhythm = 9;  // [rad/s]

/// Joints of endless strength that swing about zero: their rotors are so heavy that nothing else moves them.
class EndlessServo final : public RobotModule {
 public:
  void declare(Declaration& d) const override {
    d.runsIn(Phase::kEvaluate);
    d.reads(kJointPosition, subset::kJoints);
    d.accumulates(kJointTorque, subset::kJoints);
    d.accumulates(kJointInertia, subset::kJoints);
  }
  void bind(Links& links) override {
    q_ = links.values(kJointPosition, subset::kJoints);
    torque_ = links.values(kJointTorque, subset::kJoints), inertia_ = links.values(kJointInertia, subset::kJoints);
  }
  void stepRobot(const RobotLane& robot, const StepTime&) const override {
    for (int j = 0; j < q_.objects; ++j) {
      robot.set(torque_, -kRotor * kRhythm * kRhythm * robot.get(q_, j), j);
      robot.set(inertia_, kRotor, j);
    }
  }

 private:
  static constexpr double kRotor = 1e7;  // [kg m^2]
  RobotValues<double> q_, torque_, inertia_;
};

double amplitudeOf(int joint) { return 0.1 + 0.02 * joint; }

/// Where the base of a tossed robot is after a fifth of a second in which its joints swing.
Pose swungBase(const DynamicLevel& level, double step) {
  DynamicWorld world(step);
  world.registry().add<EndlessServo>("endless_servo", "actuation", "for tests");
  const ObjectId robot = world.add("robot", ks21(), std::vector<double>(21, 0.0));
  for (const ObjectId joint : world.world().members(robot, subset::kJoints)) {
    world.world().set(joint, kLowerLimit, -3.0), world.world().set(joint, kUpperLimit, 3.0);
  }
  world.link(level);
  toss(world, robot, kTossed, kSpin);
  auto dq = world.linked().handle(robot, kJointVelocity, subset::kJoints);
  for (int j = 0; j < 21; ++j) dq.set(kRhythm * amplitudeOf(j), j);
  while (world.time() < 0.2 - step / 2) {
    std::vector<double> q;
    for (int j = 0; j < 21; ++j) q.push_back(amplitudeOf(j) * std::sin(kRhythm * (world.time() + step)));
    world.command(robot, q);
    world.step();
  }
  return world.base(robot);
}

TEST(SimplifiedFlight, ComesToMultibodyDynamicsWithServosOfEndlessStrengthAsStepsGetShorter) {
  const DynamicLevel endless{{"endless_servo", "tree_motion", "multibody_dynamics", "runge_kutta_4"}};
  const Pose reference = swungBase(endless, 5e-4);
  const auto errorOf = [&](double step) {
    const DynamicLevel level =
        simplified("").with("tracking_servo.lag", 0).with("tracking_servo.largest_acceleration", 0);
    const Pose X = swungBase(level, step);
    return norm(X.translation - reference.translation) + norm(rotationLog(transposed(X.rotation) * reference.rotation));
  };
  const double coarse = errorOf(2e-3), fine = errorOf(1e-3);
  EXPECT_LT(fine, 2e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.1);
}

TEST(SimplifiedFlight, WhatSomebodyMovesInFlightStaysWhereItWasPut) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), gait(0, {}, 0));
  world.link(simplified(""));
  toss(world, robot, kTossed, kSpin);
  while (world.time() < 0.1) swing(world, robot, 0.5), world.step();
  // The same base at rest with other joints, which their commands hold.
  const std::vector<double> other = gait(0.3, {0.1, 0, 0.2});
  for (int j = 0; j < 21; ++j) {
    world.linked().handle(robot, kJointPosition, subset::kJoints).set(other[static_cast<std::size_t>(j)], j);
    world.linked().handle(robot, kJointVelocity, subset::kJoints).set(0, j);
  }
  world.command(robot, other);
  toss(world, robot, kTossed, {});
  world.run(0.1);
  EXPECT_LT(norm(world.base(robot).translation - kTossed.translation - Vector3{0, 0, -kG / 200}), 1e-13);
  EXPECT_LT(norm(rotationLog(transposed(kTossed.rotation) * world.base(robot).rotation)), 1e-13);
}

TEST(SimplifiedFlight, LanesEqualScalarBitForBit) {
  const auto fly = [](int robots, int lanes, int first) {
    DynamicWorld world(1e-3);
    for (int i = 0; i < robots; ++i) world.add("robot" + std::to_string(i), ks21(), gait(0, {}, 0));
    world.link(simplified(""), lanes);
    for (int i = 0; i < robots; ++i) {
      toss(world, world.robots()[static_cast<std::size_t>(i)], kTossed, kSpin * (0.3 * (first + i)));
    }
    for (int k = 0; k < 100; ++k) {
      for (int i = 0; i < robots; ++i) swing(world, world.robots()[static_cast<std::size_t>(i)], 0.1 * (first + i));
      if (k == 50 && robots + first > 2) toss(world, world.robots()[static_cast<std::size_t>(2 - first)], kTossed, {});
      world.step();
    }
    std::vector<Pose> poses;
    for (const ObjectId robot : world.robots()) poses.push_back(world.base(robot));
    return poses;
  };
  const std::vector<Pose> eight = fly(8, 8, 0), four = fly(4, 4, 0);
  for (int i = 0; i < 2; ++i) {
    const Pose alone = fly(1, 1, i)[0];
    EXPECT_EQ(std::memcmp(&eight[static_cast<std::size_t>(i)], &alone, sizeof(Pose)), 0) << i;
    EXPECT_EQ(std::memcmp(&four[static_cast<std::size_t>(i)], &alone, sizeof(Pose)), 0) << i;
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(std::memcmp(&eight[i], &four[i], sizeof(Pose)), 0) << i;
}

}  // namespace
}  // namespace murosimf::motion
