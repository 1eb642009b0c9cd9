// Kinematic walking with the robot and the gait that games are played with.

#include <gtest/gtest.h>

#include <cmath>

#include "modules/motion_world.h"

namespace murosimf::motion {
namespace {

constexpr double kPeriod = 0.52;  // of the gait [s]
using controllers::WalkCommand;

struct Walker {
  MotionWorld motion;
  ObjectId robot;
  explicit Walker(double step = 0.01, const WalkCommand& command = {}, double amplitude = 1)
      : motion(step), robot(motion.add("robot", ks21(), gait(0, command, amplitude))) {
    motion.link();
  }
  void cycles(const WalkCommand& command, int count, double step = 0.01) {
    motion.walk(command, std::lround(count * kPeriod / step));
  }
};

/// Mean velocity over ten cycles, in the axes of the base at their beginning.
WalkCommand measured(const WalkCommand& command, double step) {
  Walker walker(step, command);
  walker.cycles(command, 2, step);
  const Pose begin = walker.motion.base(walker.robot);
  double turned = 0, heading = headingOf(begin);
  for (int i = 0; i < 10; ++i) {
    walker.cycles(command, 1, step);
    const double now = headingOf(walker.motion.base(walker.robot));
    turned += wrapAngle(now - heading), heading = now;
  }
  const Vector3 moved = walker.motion.base(walker.robot).translation - begin.translation;
  const SinCos<double> t = sincos(headingOf(begin));
  const double time = 10 * kPeriod;
  return {(t.cos * moved.x + t.sin * moved.y) / time, (-t.sin * moved.x + t.cos * moved.y) / time, turned / time};
}

TEST(Ks21Walk, TheCommandedSpeedIsWalked) {
  for (const double step : {0.01, 0.001}) {
    for (const double vx : {0.0, 0.05, 0.10, 0.15, 0.20, -0.10}) {
      const WalkCommand v = measured({vx, 0, 0}, step);
      EXPECT_NEAR(v.vx, vx, 1e-5) << step;
      EXPECT_NEAR(v.vy, 0, 1e-5) << step;
      EXPECT_NEAR(v.omega, 0, 1e-5) << step;
    }
    EXPECT_NEAR(measured({0, 0.05, 0}, step).vy, 0.05, 1e-5) << step;
    EXPECT_NEAR(measured({0, 0, 0.5}, step).omega, 0.5, 1e-5) << step;
  }
}

TEST(Ks21Walk, ACycleAtTwentyCentimetresASecondIsTenCentimetresLong) {
  const WalkCommand command{0.20, 0, 0};
  Walker walker(0.01, command);
  walker.cycles(command, 3);
  const double before = walker.motion.base(walker.robot).translation.x;
  walker.cycles(command, 1);
  EXPECT_NEAR(walker.motion.base(walker.robot).translation.x - before, 0.104, 1e-6);
}

TEST(Ks21Walk, FeetChangeRolesTwiceACycleWhateverTheCommand) {
  for (const WalkCommand& command :
       {WalkCommand{}, {0.20, 0, 0}, {-0.10, 0, 0}, {0, 0.05, 0}, {0, 0, 0.5}, {0.10, 0.03, 0.30}}) {
    for (const double step : {0.01, 0.001}) {
      Walker walker(step, command);
      walker.motion.walk(command, std::lround(1.25 * kPeriod / step));
      int exchanges = 0;
      double stance = walker.motion.get(walker.robot, kStanceSide);
      for (long i = 0; i < std::lround(10 * kPeriod / step); ++i) {
        walker.motion.walk(command, 1);
        exchanges += walker.motion.get(walker.robot, kStanceSide) != stance ? 1 : 0;
        stance = walker.motion.get(walker.robot, kStanceSide);
      }
      EXPECT_EQ(exchanges, 20) << command.vx << " " << command.vy << " " << command.omega << " " << step;
    }
  }
}

TEST(Ks21Walk, TheLowestCornerStaysOnTheGround) {
  const WalkCommand command{0.10, 0.03, 0.30};
  Walker walker(0.01, command);
  for (int i = 0; i < 520; ++i) {
    walker.motion.walk(command, 1);
    ASSERT_NEAR(walker.motion.lowestCorner(walker.robot), 0, 1e-12) << i;
  }
}

TEST(Ks21Walk, TenMillisecondsAStepAreAsGoodAsOne) {
  for (const WalkCommand& command : {WalkCommand{0.20, 0, 0}, {0.10, 0.03, 0.30}, {-0.10, 0.05, -0.5}}) {
    Walker coarse(0.01, command), fine(0.001, command);
    coarse.cycles(command, 1, 0.01), fine.cycles(command, 1, 0.001);
    const Pose a0 = coarse.motion.base(coarse.robot), b0 = fine.motion.base(fine.robot);
    for (int i = 0; i < 20; ++i) {
      coarse.cycles(command, 1, 0.01), fine.cycles(command, 1, 0.001);
      const Pose a = inverse(a0) * coarse.motion.base(coarse.robot), b = inverse(b0) * fine.motion.base(fine.robot);
      EXPECT_LT(norm(a.translation - b.translation), 1e-4) << "after " << 2 * (i + 1) << " steps";
    }
  }
}

TEST(Ks21Walk, AMillionStepsOfStandingChangeNoBit) {
  Walker walker(0.01, {}, 0);
  walker.motion.walk({}, 52);  // steps on the spot, and stops in mid-stride
  walker.motion.walk({}, 20, 0);
  const Pose base = walker.motion.base(walker.robot);
  for (int i = 0; i < 1'000'000; ++i) walker.motion.step();
  EXPECT_EQ(walker.motion.base(walker.robot), base);
}

TEST(Ks21Walk, TheBaseMovesSmoothly) {
  const WalkCommand command{0.20, 0, 0};
  Walker walker(0.001, command);
  walker.cycles(command, 1, 0.001);
  Vector3 last = walker.motion.base(walker.robot).translation, last_velocity{};
  for (int i = 0; i < 1040; ++i) {
    walker.motion.walk(command, 1);
    const Vector3 now = walker.motion.base(walker.robot).translation, velocity = (now - last) * 1000;
    if (i > 0) {
      EXPECT_LT(norm(velocity - last_velocity), 0.03) << i;  // [m/s] in a millisecond
    }
    last = now, last_velocity = velocity;
  }
}

/// The gait with one ankle turned: its sole is not parallel to the other one.
std::vector<double> limp(double phase, const WalkCommand& command, double tilt) {
  std::vector<double> q = gait(phase, command);
  q[20] += tilt;  // left ankle roll
  return q;
}

TEST(Ks21Walk, ATiltedSoleIsPutDownFlatAndTheJumpIsFadedOut) {
  const double tilt = 3 * kPi / 180;
  const WalkCommand command{0.1, 0, 0};
  Walker walker(0.01, command);
  int exchanges = 0;
  double stance = 1, largest_jump = 0;
  Vector3 last{};
  for (int i = 0; i < 104; ++i) {
    walker.motion.command(walker.robot, limp((i + 1) * 0.01 / kPeriod, command, tilt));
    walker.motion.step();
    const Vector3 now = walker.motion.base(walker.robot).translation;
    if (i > 10) largest_jump = max(largest_jump, norm(now - last));
    last = now;
    exchanges += walker.motion.get(walker.robot, kStanceSide) != stance ? 1 : 0;
    stance = walker.motion.get(walker.robot, kStanceSide);
  }
  EXPECT_LE(exchanges, 5);  // four in two cycles, perhaps one at the start: no chatter
  // Without fading out the hip would jump by its height times the tilt, 13 mm; it moves by 2 mm a step anyway.
  EXPECT_LT(largest_jump, 0.006);
}

TEST(Ks21Walk, AfterTheJumpHasFadedTheStanceSoleIsFlatOnTheGround) {
  Walker walker;
  std::vector<double> q = gait(0, {}, 0);
  walker.motion.command(walker.robot, q);
  walker.motion.step();
  ASSERT_EQ(walker.motion.get(walker.robot, kStanceSide), 1);
  q[14] += 0.05, q[12] += 0.1;  // right ankle roll; right knee: lifts the right foot ...
  for (int i = 0; i < 10; ++i) walker.motion.command(walker.robot, q), walker.motion.step();
  q[12] -= 0.1, q[18] += 0.1;  // ... and puts it down tilted, then lifts the left one
  for (int i = 0; i < 10; ++i) walker.motion.command(walker.robot, q), walker.motion.step();
  ASSERT_EQ(walker.motion.get(walker.robot, kStanceSide), 0);
  const Pose X_WS = walker.motion.sole(walker.robot, 0);
  EXPECT_NEAR(X_WS.rotation.z.z, 1, 1e-15);
  EXPECT_NEAR(X_WS.translation.z, 0, 1e-15);
}

}  // namespace
}  // namespace murosimf::motion
