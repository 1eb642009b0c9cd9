// What gyroscope and accelerometer say of motions that are known.

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/stilt_walker.h"

namespace murosimf::motion {
namespace {

struct Unit {
  MotionWorld motion{0.001};
  ObjectId robot;
  Unit() : robot(motion.add("robot", stiltWalker(), std::vector<double>(6, 0.0))) { motion.link(); }
  void move(const std::vector<double>& q) {
    motion.command(robot, q);
    motion.step();
  }
  Vector3 rate() const { return motion.get(robot, kGyroscope, subset::kImus); }
  Vector3 force() const { return motion.get(robot, kAccelerometer, subset::kImus); }
};

TEST(InertialSensor, AtRestItFeelsTheGroundPushUpward) {
  Unit unit;
  for (int i = 0; i < 10; ++i) {
    unit.move(std::vector<double>(6, 0.0));
    EXPECT_EQ(unit.rate(), (Vector3{0, 0, 0}));
    EXPECT_EQ(unit.force(), (Vector3{0, 0, 9.81}));
  }
}

TEST(InertialSensor, OnATiltedBodyGravityIsTurnedIntoItsAxes) {
  MotionWorld motion(0.01);
  const ObjectId robot = motion.add("robot", ks21(), gait(0, {}, 0));
  motion.link();
  motion.command(robot, gait(0, {}, 0));
  for (int i = 0; i < 20; ++i) motion.step();
  const double lean = 6.5 * kPi / 180;  // of the trunk in the gait: nose down
  EXPECT_NEAR(motion.get(robot, kAccelerometer, subset::kImus).x, -9.81 * sin(lean), 1e-9);
  EXPECT_NEAR(motion.get(robot, kAccelerometer, subset::kImus).z, 9.81 * cos(lean), 1e-9);
  EXPECT_NEAR(norm(motion.get(robot, kGyroscope, subset::kImus)), 0, 1e-12);
}

TEST(InertialSensor, OnATurningBaseItFeelsTheRateAndTheCentripetalForce) {
  book::Page page({book::Chapter::kSensors,
                   "In circular motion an accelerometer feels the force towards the centre",
                   R"(f = \omega^2 r)",
                   "Kinematics of a circle; the gyroscope reads the rate",
                   {{"r", "from the foot that stands to the unit", "m"}},
                   {"rate $\\omega$", "rad/s"},
                   {"specific force $f$", "m/s^2"}});
  page.curve(0, 1.2, [](double rate) { return rate * rate * kHalfStance; });
  for (const double rate : {0.2, 0.4, 0.8, 1.2}) {  // the left foot stands and turns against the base
    Unit unit;
    unit.move({0, 0, 0.01, 0, 0, 0});
    for (int i = 1; i <= 200; ++i) {
      const double t = 0.001 * i;
      unit.move({0, 0, 0.01, -rate * t, 0, 0});
      EXPECT_NEAR(unit.rate().z, rate, 1e-9);
      EXPECT_NEAR(unit.rate().x, 0, 1e-12);
      if (i < 3) continue;
      // The foot is kHalfStance to the left (+y) of the unit: the circle's centre.
      EXPECT_NEAR(unit.force().y, rate * rate * kHalfStance, 1e-5);
      EXPECT_NEAR(unit.force().x, 0, 1e-4 * max(1.0, rate / 0.8));
      EXPECT_NEAR(unit.force().z, 9.81, 1e-9);
    }
    EXPECT_TRUE(page.near(rate, unit.force().y, rate * rate * kHalfStance, 1e-5));
  }
}

TEST(InertialSensor, InFreeFallItFeelsNothing) {
  Unit unit;
  unit.move(std::vector<double>(6, 0.0));
  for (int i = 1; i <= 100; ++i) {
    const double t = 0.001 * i, up = 0.5 * 9.81 * t * t;
    unit.move({0, 0, up, 0, 0, up});
    if (i > 1) {
      EXPECT_NEAR(norm(unit.force()), 0, 1e-8);
    }
  }
}

TEST(InertialSensor, ThePlaceOfTheUnitOnATurningBodyCounts) {
  // KS21's unit sits in the trunk: turned at the waist while the feet stand, it feels the waist's rate.
  MotionWorld motion(0.01);
  std::vector<double> q = gait(0, {}, 0);
  const ObjectId robot = motion.add("robot", ks21(), q);
  motion.link();
  for (int i = 1; i <= 50; ++i) {
    q[0] = 0.5 * 0.01 * i;
    motion.command(robot, q);
    motion.step();
  }
  EXPECT_NEAR(norm(motion.get(robot, kGyroscope, subset::kImus)), 0.5, 1e-9);
  EXPECT_NEAR(motion.get(robot, kGyroscope, subset::kImus).z, 0.5, 1e-9);  // the waist's axis is the trunk's z
}

}  // namespace
}  // namespace murosimf::motion
