// Robots with more than one inertial measurement unit, at all levels of detail.

#include <gtest/gtest.h>

#include "modules/dynamic_world.h"

namespace murosimf::motion {
namespace {

constexpr std::size_t kHeadPan = 1;

ImuMount unitOn(const RobotBlueprint& print, const std::string& name, const std::string& body, const Pose& X_BI) {
  ImuMount unit;
  unit.name = name, unit.body = print.model.tree.bodyIndex(body), unit.X_BI = X_BI;
  return unit;
}

/// KS21 with a second unit on its skull, in the skull's axes.
const RobotBlueprint& ks21WithTwo() {
  static const RobotBlueprint print = [] {
    RobotBlueprint made = ks21();
    made.model.imus.push_back(unitOn(made, "imu_head", "skull", {Rotation3{}, {0.01, 0.02, 0.03}}));
    return made;
  }();
  return print;
}

struct Level {
  const char* name;
  DynamicLevel modules;
  const char* sensor;
};
const std::vector<Level> kLevels{{"fast", simplified(), "prescribed_inertial_sensor"},
                                 {"full", multibody(), "dynamic_inertial_sensor"}};

DynamicLevel withSensor(const Level& level) {
  DynamicLevel modules = level.modules;
  modules.modules.emplace_back(level.sensor);
  return modules;
}

/// KS21 stands and turns its head, robot number i this fast [rad/s].
double rateOf(std::size_t i) { return 0.4 + 0.1 * static_cast<double>(i); }
void turnHeads(DynamicWorld& world, double seconds) {
  for (double t = 0.01; t < seconds; t += 0.01) {
    for (std::size_t i = 0; i < world.robots().size(); ++i) {
      std::vector<double> q = gait(0, {}, 0);
      q[kHeadPan] = rateOf(i) * t;
      world.command(world.robots()[i], q);
    }
    world.run(0.01);
  }
}

struct Readings {
  Vector3 rate[2], force[2];
};
Readings readingsOf(const DynamicWorld& world, ObjectId robot) {
  Readings out;
  for (int i = 0; i < 2; ++i) {
    out.rate[i] = world.get(robot, kGyroscope, subset::kImus, i);
    out.force[i] = world.get(robot, kAccelerometer, subset::kImus, i);
  }
  return out;
}

TEST(SeveralImus, OneOnTheHeadTurnsWithItWhileThatOfTheTrunkDoesNot) {
  for (const Level& level : kLevels) {
    DynamicWorld world(1e-3);
    const ObjectId robot = world.add("robot", ks21WithTwo(), gait(0, {}, 0));
    world.link(withSensor(level));
    turnHeads(world, 1);
    const Readings read = readingsOf(world, robot);
    const double q = world.get(robot, kJointPosition, subset::kJoints, kHeadPan);
    const double dq = world.get(robot, kJointVelocity, subset::kJoints, kHeadPan);
    EXPECT_GT(dq, 0.2) << level.name;
    const Vector3 expected = applyTransposed(rotationZ(q), read.rate[0]) + Vector3{0, 0, dq};
    EXPECT_LT(norm(read.rate[1] - expected), 1e-3) << level.name;
    EXPECT_LT(norm(read.rate[0]), 0.1) << level.name;
  }
}

TEST(SeveralImus, AtRestEachFeelsTheGroundPushInItsOwnAxes) {
  for (const Level& level : kLevels) {
    RobotBlueprint print = ks21();
    const Rotation3 R_BI = rotationX(0.5) * rotationZ(-1.2);
    print.model.imus.push_back(unitOn(print, "askew", "pelvis", {R_BI, {0.03, -0.02, 0.05}}));
    DynamicWorld world(1e-3);
    const ObjectId robot = world.add("robot", print, std::vector<double>(21, 0.0));
    world.link(withSensor(level));
    world.run(3);
    const Readings read = readingsOf(world, robot);
    const Vector3 up{world.base(robot).rotation.x.z, world.base(robot).rotation.y.z, world.base(robot).rotation.z.z};
    EXPECT_LT(norm(read.force[1] - applyTransposed(R_BI, up * 9.81)), 0.02) << level.name;
    EXPECT_NEAR(norm(read.force[0]), 9.81, 0.02) << level.name;
  }
}

TEST(SeveralImus, ASecondOneLeavesTheBitsOfTheFirstAndOneInTheSamePlaceRepeatsThem) {
  for (const Level& level : kLevels) {
    RobotBlueprint twins = ks21();
    ImuMount second = twins.model.imus.front();
    second.name = "imu_again";
    twins.model.imus.push_back(second);
    Vector3 alone[2];
    for (const bool single : {true, false}) {
      DynamicWorld world(1e-3);
      const ObjectId robot = world.add("robot", single ? ks21() : twins, gait(0, {}, 0));
      world.link(withSensor(level));
      turnHeads(world, 0.5);
      const Vector3 rate = world.get(robot, kGyroscope, subset::kImus),
                    force = world.get(robot, kAccelerometer, subset::kImus);
      if (single) {
        alone[0] = rate, alone[1] = force;
        continue;
      }
      EXPECT_EQ(rate, alone[0]) << level.name;
      EXPECT_EQ(force, alone[1]) << level.name;
      EXPECT_EQ(world.get(robot, kGyroscope, subset::kImus, 1), rate) << level.name;
      EXPECT_EQ(world.get(robot, kAccelerometer, subset::kImus, 1), force) << level.name;
    }
  }
}

std::vector<Vector3> readingsInLanes(const Level& level, int lanes) {
  DynamicWorld world(1e-3);
  for (int i = 0; i < 9; ++i) world.add("robot" + std::to_string(i), ks21WithTwo(), gait(0, {}, 0));
  world.link(withSensor(level), lanes);
  turnHeads(world, 0.3);
  std::vector<Vector3> all;
  for (const ObjectId robot : world.robots()) {
    const Readings read = readingsOf(world, robot);
    for (int i = 0; i < 2; ++i) all.push_back(read.rate[i]), all.push_back(read.force[i]);
  }
  return all;
}

TEST(SeveralImus, GiveInLanesTheBitsOfTheScalar) {
  for (const Level& level : kLevels) {
    const std::vector<Vector3> scalar = readingsInLanes(level, 1);
    EXPECT_EQ(readingsInLanes(level, 4), scalar) << level.name;
    EXPECT_EQ(readingsInLanes(level, 8), scalar) << level.name;
  }
}

/// What both units of kinematic robots read that turn their heads.
std::vector<Vector3> kinematicReadings(int lanes) {
  MotionWorld motion(0.01);
  std::vector<ObjectId> robots;
  std::vector<double> q = gait(0, {}, 0);
  for (int i = 0; i < 9; ++i) robots.push_back(motion.add("robot" + std::to_string(i), ks21WithTwo(), q));
  motion.link(lanes);
  for (int k = 1; k <= 50; ++k) {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      q[kHeadPan] = rateOf(i) * 0.01 * k;
      motion.command(robots[i], q);
    }
    motion.step();
  }
  std::vector<Vector3> all;
  for (const ObjectId robot : robots) {
    for (int i = 0; i < 2; ++i) {
      all.push_back(motion.get(robot, kGyroscope, subset::kImus, i));
      all.push_back(motion.get(robot, kAccelerometer, subset::kImus, i));
    }
  }
  return all;
}

TEST(SeveralImus, OfKinematicRobotsFeelTheHeadTurnWithTheBitsOfTheScalar) {
  const std::vector<Vector3> scalar = kinematicReadings(1);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_LT(norm(scalar[4 * i]), 1e-12);
    EXPECT_NEAR(scalar[4 * i + 2].z, rateOf(i), 1e-9);
    EXPECT_LT(std::hypot(scalar[4 * i + 2].x, scalar[4 * i + 2].y), 1e-9);
    EXPECT_NEAR(norm(scalar[4 * i + 1]), 9.81, 1e-9);
  }
  EXPECT_EQ(kinematicReadings(4), scalar);
  EXPECT_EQ(kinematicReadings(8), scalar);
}

}  // namespace
}  // namespace murosimf::motion
