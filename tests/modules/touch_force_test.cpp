// Touch and force sensors against the laws of motion, and against other sensors of the same robot.

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/single_body.h"
#include "modules/test_rig.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81;

SurfacePair hardGround() {
  SurfacePair pair;
  pair.stiffness = 1e4, pair.dissipation = 20;
  return pair;
}

Vector3 sensedForce(TestRig& rig, int sensor = 0) { return rig.get(kSensedForce, subset::kForceSensors, sensor); }

TEST(ForceSensor, FeelsWhatAPendulumDoesToItsPivot) {
  book::Page page({book::Chapter::kSensors,
                   "A force sensor feels what a pendulum does to its pivot",
                   "f_x = m g \\sin q \\left( 1 - \\frac{m l^2}{I} \\right)\n"
                   R"(f_z = -m (g \cos q + l \omega^2))",
                   "Newton and Euler of a physical pendulum",
                   {{"m", "mass, here 2", "kg"},
                    {"l", "from the pivot to the centre of mass, here 0.3", "m"},
                    {"I", "inertia about the pivot", "kg m^2"},
                    {"\\omega", "rate, here 3", "rad/s"}},
                   {"angle $q$", "rad"},
                   {"force on the pivot $f$", "N"}});
  const double m = 2, l = 0.3, I_C = 0.05, I = I_C + m * l * l, w = 3;
  const auto across = [&](double q) { return m * kG * std::sin(q) * (1 - m * l * l / I); };
  const auto along = [&](double q) { return -m * (kG * std::cos(q) + l * w * w); };
  page.series("$f_x$").curve(-1, 2.5, across), page.series("$f_z$").curve(-1, 2.5, along);
  for (const double q : {-1.0, 0.0, 0.7, 1.5, 2.5}) {
    TestRig rig(stand());
    rig.joint(0, JointKind::kRevolute, 1, {0.1, 0, 0}, shifted(rigidBody(m, {0.04, I_C, 0.02}), Vector3{0, 0, -l}));
    rig.forceSensor(0).use({"force_sensor"}).use<Support>("support");
    rig.link("explicit_euler", 1e-3);
    rig.set(0, q, w);
    rig.run(1e-3);  // one evaluation, in the state that was set
    const Vector3 felt = sensedForce(rig);
    EXPECT_TRUE(page.series("$f_x$").near(q, felt.x, across(q), 1e-9));
    EXPECT_NEAR(felt.y, 0, 1e-9);
    EXPECT_TRUE(page.series("$f_z$").near(q, felt.z, along(q), 1e-9));
  }
}

TEST(ForceSensor, OfAChainAtRestFeelsAllThatHangsBelowInItsOwnAxes) {
  TestRig rig(stand());
  const Rotation3 R = rotationX(0.7) * rotationZ(0.2);
  rig.joint(0, JointKind::kRevolute, 1, {}, pointMass(3, {0, 0, -0.2}));
  rig.joint(1, JointKind::kRevolute, 0, {0, 0, -0.2}, pointMass(2, {0, 0, -0.1}));
  rig.forceSensor(0).forceSensor(1, R).use({"force_sensor"}).use<Support>("support");
  rig.link("implicit_euler", 1e-3);
  rig.run(0.1);
  EXPECT_LT(norm(sensedForce(rig, 0) - Vector3{0, 0, -5 * kG}), 1e-9);
  EXPECT_LT(norm(sensedForce(rig, 1) - applyTransposed(R, Vector3{0, 0, -2 * kG})), 1e-9);
}

TEST(ForceSensor, OfASliderFeelsNothingAlongItsAxis) {
  TestRig rig(stand());
  rig.joint(0, JointKind::kPrismatic, 2, {}, rigidBody(2, {0.1, 0.1, 0.1}));
  rig.forceSensor(0).use({"force_sensor"}).use<Support>("support");
  rig.link("runge_kutta_4", 1e-3);
  rig.run(0.1);
  EXPECT_NEAR(sensedForce(rig).z, 0, 1e-9);
  EXPECT_NEAR(rig.dq(0), -0.981, 1e-9) << "it was to fall";
}

int firstBody(const RobotBlueprint& print, std::size_t row) { return print.flat.row_bodies[row].front(); }

/// A force sensor on this row, with its axes.
void addForceSensor(RobotBlueprint& print, std::size_t row) {
  const int body = firstBody(print, row);
  ForceSensorMount sensor;
  sensor.name = "force_" + std::to_string(row), sensor.body = body;
  sensor.X_BM = inverse(print.flat.bodies[static_cast<std::size_t>(body)].X_RB);
  print.model.force_sensors.push_back(sensor);
}

RobotBlueprint withFeetThatFeel() {
  RobotBlueprint print = ks21();
  for (const SolePlace& sole : [&] {
         World world;
         return *world.findShared(addRobot(world, "r", print, Colour{}), kSoles);
       }()) {
    addForceSensor(print, static_cast<std::size_t>(sole.mount.row));
    TouchSensorMount touch;
    touch.name = "touch_" + std::to_string(sole.mount.row);
    touch.body = firstBody(print, static_cast<std::size_t>(sole.mount.row));
    print.model.touch_sensors.push_back(touch);
  }
  return print;
}

double massOf(const RobotBlueprint& print) { return print.model.tree.mass(); }

double massOfFeet(const RobotBlueprint& print) {
  double sum = 0;
  for (const ForceSensorMount& sensor : print.model.force_sensors) {
    const int row = print.flat.bodies[static_cast<std::size_t>(sensor.body)].row;
    sum += print.flat.row_mass[static_cast<std::size_t>(row)].mass;
  }
  return sum;
}

TEST(ForceSensor, InTheAnklesOfAStandingRobotBearAllButItsFeet) {
  const RobotBlueprint print = withFeetThatFeel();
  const double weight = (massOf(print) - massOfFeet(print)) * kG;
  EXPECT_GT(massOfFeet(print), 0.1);
  for (DynamicLevel level : {multibody(), simplified()}) {
    DynamicWorld world(1e-3);
    const ObjectId robot = world.add("robot", print, gait(0, {}, 0));
    level.modules.emplace_back("force_sensor");
    level.modules.emplace_back("touch_sensor");
    world.link(level);
    world.run(3);
    Vector3 sum;
    double pressed = 0;
    for (int s = 0; s < 2; ++s) {
      sum += world.get(robot, kSensedForce, subset::kForceSensors, s);
      pressed += world.get(robot, kTouchForce, subset::kTouchSensors, s);
    }
    EXPECT_NEAR(sum.z, weight, 2e-3 * weight);
    EXPECT_NEAR(pressed, massOf(print) * kG, 2e-3 * weight);
  }
}

TEST(ForceSensor, OfAFootThatHangsInFreeFallFeelsNothing) {
  const RobotBlueprint print = withFeetThatFeel();
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", print, gait(0, {}, 0));
  DynamicLevel level = multibody();
  level.modules.emplace_back("force_sensor");
  level.modules.emplace_back("touch_sensor");
  world.link(level);
  world.linked().handle(robot, kBasePose).set({rotationX(0.3), {0, 0, 3}});
  world.run(0.2);
  for (int s = 0; s < 2; ++s) {
    EXPECT_LT(norm(world.get(robot, kSensedForce, subset::kForceSensors, s)), 1e-6);
    EXPECT_EQ(world.get(robot, kTouch, subset::kTouchSensors, s), 0);
  }
}

/// Sensors wherever something hangs on the pelvis, which has an accelerometer at its centre of mass.
RobotBlueprint withPelvisThatIsWeighed() {
  RobotBlueprint print = ks21();
  const std::vector<TreeRow>& rows = print.flat.table.rows;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].parent == 0) addForceSensor(print, i);
  }
  ImuMount& imu = print.model.imus.front();
  imu.body = firstBody(print, 0);
  imu.X_BI = inverse(print.flat.bodies[static_cast<std::size_t>(imu.body)].X_RB) *
             Pose{Rotation3{}, print.flat.row_mass[0].p_BC_B};
  return print;
}

TEST(ForceSensor, WhatHangsOnAWalkersPelvisAcceleratesItAsItsAccelerometerFeels) {
  const RobotBlueprint print = withPelvisThatIsWeighed();
  ASSERT_EQ(print.model.force_sensors.size(), 3U);  // two legs and the waist
  const std::vector<KernelRow> rows = kernelRows(print.flat.table);
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", print, gait(0, {}, 0));
  DynamicLevel level = multibody();
  level.modules.emplace_back("force_sensor");
  level.modules.emplace_back("dynamic_inertial_sensor");
  world.link(level);
  double largest = 0;
  for (int k = 0; k < 600; ++k) {
    world.command(robot, gait(k / 520.0, {0.1, 0, 0}, 1));
    std::vector<double> q;
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      q.push_back(world.get(robot, kJointPosition, subset::kJoints, static_cast<int>(j)));
    }
    world.step();
    Vector3 sum;
    for (std::size_t s = 0; s < print.model.force_sensors.size(); ++s) {
      const int body = print.model.force_sensors[s].body;
      const int row = print.flat.bodies[static_cast<std::size_t>(body)].row;
      const Pose X_PC = childPose(Pose{}, rows[static_cast<std::size_t>(row)], q[static_cast<std::size_t>(row) - 1]);
      sum += X_PC.rotation * world.get(robot, kSensedForce, subset::kForceSensors, static_cast<int>(s));
    }
    const Vector3 felt = world.get(robot, kAccelerometer, subset::kImus) * print.flat.row_mass[0].mass;
    ASSERT_LT(norm(sum - felt), 1e-8) << k;
    largest = max(largest, norm(felt));
  }
  EXPECT_GT(world.upright(robot), 0.9);
  EXPECT_GT(largest, 1.2 * print.flat.row_mass[0].mass * kG) << "it was to be shaken";
}

TEST(TouchSensor, UnderAFootFeelsTheSumOfThePressuresUnderItsCorners) {
  const RobotBlueprint print = withFeetThatFeel();
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", print, gait(0, {}, 0));
  DynamicLevel level = multibody();
  level.modules.emplace_back("touch_sensor");
  level.modules.emplace_back("foot_pressure");
  world.link(level);
  int closed = 0, open = 0;
  for (int k = 0; k < 600; ++k) {
    world.command(robot, gait(k / 520.0, {0.1, 0, 0}, 1));
    world.step();
    for (int s = 0; s < 2; ++s) {
      const CornerForces<> corners = world.get(robot, kSolePressure, subset::kSoles, s);
      const double sum = corners.of[0] + corners.of[1] + corners.of[2] + corners.of[3];
      const double force = world.get(robot, kTouchForce, subset::kTouchSensors, s);
      ASSERT_NEAR(force, sum, 1e-9 * (1 + std::fabs(sum))) << k;
      ASSERT_EQ(world.get(robot, kTouch, subset::kTouchSensors, s), force > 1 ? 1 : 0);
      ++(force > 1 ? closed : open);
    }
  }
  EXPECT_GT(open, 100);
  EXPECT_GT(closed, 500);
}

TouchSensorMount touchOn(int body, double threshold = 1) {
  TouchSensorMount sensor;
  sensor.name = "touch_" + std::to_string(body), sensor.body = body, sensor.threshold = threshold;
  return sensor;
}

/// A box with two plates fixed to it, one below and one above, each with a touch sensor.
RobotBlueprint boxWithBumpers(double threshold) {
  const auto plate = [](const char* name) {
    Body body{name, {}};
    BodyShape shape;
    shape.shape = makeBox({0.1, 0.05, 0.005}), shape.surface = "plastic";
    body.shapes.push_back(shape);
    return body;
  };
  TreeBuilder builder;
  const TreePlace base = builder.base("base");
  base.body({"box", boxMass(2, {0.2, 0.1, 0.06}, {})});
  const TreePlace fork = base.fork();
  fork.translation({0, 0, -0.03}).body(plate("below"));
  fork.translation({0, 0, 0.03}).body(plate("above"));
  RobotBlueprint print;
  print.model.name = "box";
  print.model.tree = builder.build();
  print.model.touch_sensors = {touchOn(1, threshold), touchOn(2, threshold)};
  print.flat = flattenTree(print.model.tree);
  return print;
}

struct Touch {
  double force, touch;
};
Touch touchOf(const DynamicWorld& world, int sensor) {
  const ObjectId robot = world.robots()[0];
  return {world.get(robot, kTouchForce, subset::kTouchSensors, sensor),
          world.get(robot, kTouch, subset::kTouchSensors, sensor)};
}

TEST(TouchSensor, OfTwoPlatesOnOneBodyTheLowerOneBearsItsWeight) {
  for (const char* integrator : {"implicit_euler", "runge_kutta_4"}) {
    DynamicWorld world(1e-3, onGround(hardGround()));
    const ObjectId body = world.add("body", boxWithBumpers(1), {});
    world.link({{"tree_motion", "hunt_crossley_contact", "multibody_dynamics", "touch_sensor", integrator}});
    world.linked().handle(body, kBasePose).set({rotationZ(0.4), {0, 0, 0.035}});
    world.run(1);
    EXPECT_NEAR(touchOf(world, 0).force, 2 * kG, 1e-3) << integrator;
    EXPECT_EQ(touchOf(world, 0).touch, 1);
    EXPECT_EQ(touchOf(world, 1).force, 0);
    EXPECT_EQ(touchOf(world, 1).touch, 0);
    world.linked().handle(body, kBasePose).set({rotationX(kPi), {0, 0, 0.0345}});
    world.run(1);
    EXPECT_NEAR(touchOf(world, 1).force, 2 * kG, 1e-3) << "upside down, " << integrator;
    EXPECT_EQ(touchOf(world, 0).touch, 0);
  }
}

TEST(TouchSensor, StaysOpenBelowItsThreshold) {
  DynamicWorld world(1e-3, onGround(hardGround()));
  const ObjectId body = world.add("body", boxWithBumpers(25), {});
  world.link({{"tree_motion", "hunt_crossley_contact", "multibody_dynamics", "touch_sensor", "implicit_euler"}});
  world.linked().handle(body, kBasePose).set({{}, {0, 0, 0.034}});
  world.run(1);
  EXPECT_NEAR(touchOf(world, 0).force, 2 * kG, 1e-6);
  EXPECT_EQ(touchOf(world, 0).touch, 0);
}

TEST(TouchAndForceSensors, LanesGiveTheBitsOfOneRobotAlone) {
  const RobotBlueprint print = withFeetThatFeel();
  const auto memory = [&](int lanes) {
    DynamicWorld world(1e-3);
    for (int i = 0; i < 5; ++i) world.add("r" + std::to_string(i), print, gait(0.2 * i, {}, 1));
    DynamicLevel level = multibody();
    level.modules.emplace_back("force_sensor");
    level.modules.emplace_back("touch_sensor");
    world.link(level, lanes);
    for (int k = 0; k < 200; ++k) {
      for (int i = 0; i < 5; ++i) {
        world.command(world.robots()[static_cast<std::size_t>(i)], gait(0.2 * i + k / 520.0, {0.05 * i, 0, 0}, 1));
      }
      world.step();
    }
    std::vector<double> numbers;
    for (const Place& place : world.linked().places()) {
      world.linked().visitMemory(place, [&](double value) { numbers.push_back(value); });
    }
    return numbers;
  };
  const std::vector<double> scalar = memory(1);
  EXPECT_EQ(memory(4), scalar);
  EXPECT_EQ(memory(8), scalar);
}

}  // namespace
}  // namespace murosimf::motion
