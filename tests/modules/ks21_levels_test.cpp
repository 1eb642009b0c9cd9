// KS21 at every dynamic level: stands, walks, squats, in steps of any length and in lanes.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "modules/ks21_motions.h"

namespace murosimf::motion {
namespace {

struct NamedLevel {
  const char* name;
  DynamicLevel level;
};
NamedLevel simplifiedVersion(const char* name, const char* contact, double recompute) {
  return {name, simplified(contact).with("simplified_dynamics.recompute", recompute)};
}
class Ks21Levels : public testing::TestWithParam<NamedLevel> {
 protected:
  static const DynamicLevel& level() { return GetParam().level; }
};
class Ks21Simplified : public Ks21Levels {};

std::string nameOf(const testing::TestParamInfo<NamedLevel>& test) { return test.param.name; }
const auto kSimplifiedLevels = testing::Values(simplifiedVersion("two_smooth", "smooth_contact", 1),
                                               simplifiedVersion("two_hunt_crossley", "hunt_crossley_contact", 1),
                                               simplifiedVersion("one_smooth", "smooth_contact", 0));
const auto kMultibodyLevels = testing::Values(NamedLevel{"multibody_hunt_crossley", multibody("hunt_crossley_contact")},
                                              NamedLevel{"multibody_smooth", multibody("smooth_contact")});
INSTANTIATE_TEST_SUITE_P(Simplified, Ks21Levels, kSimplifiedLevels, nameOf);
INSTANTIATE_TEST_SUITE_P(Multibody, Ks21Levels, kMultibodyLevels, nameOf);
INSTANTIATE_TEST_SUITE_P(Versions, Ks21Simplified, kSimplifiedLevels, nameOf);

TEST_P(Ks21Levels, StandsForAMinuteWithinMillimetres) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), kReady);
  world.link(level());
  world.run(1);
  const Pose settled = world.base(robot);
  world.run(60);
  EXPECT_LT(norm(world.base(robot).translation - settled.translation), 1e-3);
  EXPECT_GT(world.upright(robot), 0.99);
}

TEST_P(Ks21Levels, WalksThreeMetresForwardNearlyAsFastAsCommanded) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), kReady);
  world.link(level());
  const Way way = walk(world, robot, {0.17, 0, 0}, 20);
  const Vector3 gone = way.end.translation - way.begin.translation;
  EXPECT_GT(gone.x, 3);
  EXPECT_NEAR(gone.x / 20, 0.17, 0.15 * 0.17);
  EXPECT_NEAR(gone.y, 0, 0.3);
  EXPECT_GT(world.upright(robot), 0.97);
}

TEST_P(Ks21Levels, WalksSidewaysAndTurnsOnTheSpot) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), kReady);
  world.link(level());
  const Way way = walk(world, robot, {0, 0.05, 0}, 6);
  EXPECT_NEAR((way.end.translation - way.begin.translation).y / 6, 0.05, 0.01);
  DynamicWorld turning(1e-3);
  const ObjectId turner = turning.add("robot", ks21(), kReady);
  turning.link(level());
  const Way turn = walk(turning, turner, {0, 0, 0.5}, 6);
  EXPECT_NEAR(wrapAngle(headingOf(turn.end) - headingOf(turn.begin)), 3, 0.45);
  EXPECT_GT(turning.upright(turner), 0.97);
}

TEST_P(Ks21Simplified, SquatsOnStiffSolesInStepsOfTenMilliseconds) {
  for (const double step : {1e-3, 1e-2}) {
    DynamicWorld world(step, groundTable(5e4));
    const ObjectId robot = world.add("robot", ks21(), squat(0.211));
    world.link(level());
    double lowest = 1, fastest = 0;
    while (world.time() < 6) {
      world.command(robot, squat(0.1605 + 0.0505 * std::cos(kPi * world.time())));  // 0.5 Hz
      world.step();
      lowest = std::min(lowest, world.base(robot).translation.z);
      fastest = std::max(fastest, norm(world.get(robot, kBaseVelocity).v));
    }
    EXPECT_GT(world.upright(robot), 0.97) << step;
    EXPECT_LT(lowest, 0.16) << step;
    EXPECT_LT(fastest, 0.25) << step;  // its own way is 0.16 m/s
  }
}

TEST(Ks21Multibody, SquatsOnStiffSolesInStepsOfSixteenMilliseconds) {
  for (const double step : {1e-3, 1e-2, 1.6e-2}) {
    DynamicWorld world(step, groundTable(5e4));
    const ObjectId robot = world.add("robot", ks21(), squat(0.211));
    world.link(multibody());
    double lowest = 1, fastest = 0;
    while (world.time() < 6) {
      const double height = 0.1605 + 0.0505 * std::cos(kPi * world.time());  // 0.5 Hz
      world.command(robot, squat(height));
      world.step();
      lowest = std::min(lowest, world.base(robot).translation.z);
      for (int j = 0; j < 21; ++j) {
        fastest = std::max(fastest, std::fabs(world.get(robot, kJointVelocity, subset::kJoints, j)));
      }
    }
    EXPECT_GT(world.upright(robot), 0.97) << step;
    EXPECT_LT(lowest, 0.16) << step;
    EXPECT_LT(fastest, 4) << step;  // the knees' own way is 2 rad/s
  }
}

TEST_P(Ks21Levels, LanesEqualScalarBitForBitStandingWalkingAndFalling) {
  const auto command = [](DynamicWorld& world, std::size_t i, double t) {
    std::vector<double> q = gait(t / 0.52, {0.05 * static_cast<double>(i), 0, 0}, i == 0 ? 0.0 : 1.0);
    if (i == 2) q[11] -= 2 * t, q[17] -= 2 * t;  // bends forward until it lies
    world.command(world.robots()[std::min(i, world.robots().size() - 1)], q);
  };
  for (const int lanes : {4, 8}) {
    DynamicWorld together(1e-3);
    for (int i = 0; i < 4; ++i) together.add("robot" + std::to_string(i), ks21(), kReady);
    together.link(level(), lanes);
    for (int k = 0; k < 120; ++k) {
      for (std::size_t i = 0; i < 4; ++i) command(together, i, 0.01 * k);
      together.run(0.01);
    }
    EXPECT_LT(together.upright(together.robots()[2]), 0.5) << "the one that was to fall did not";
    for (std::size_t i = 0; i < 4; ++i) {
      DynamicWorld alone(1e-3);
      const ObjectId robot = alone.add("robot" + std::to_string(i), ks21(), kReady);
      alone.link(level());
      alone.place(0, {0, static_cast<double>(i), 0});
      for (int k = 0; k < 120; ++k) {
        command(alone, i, 0.01 * k);
        alone.run(0.01);
      }
      const Pose a = together.base(together.robots()[i]), b = alone.base(robot);
      EXPECT_EQ(std::memcmp(&a, &b, sizeof(Pose)), 0) << lanes << " " << i;
    }
  }
}

}  // namespace
}  // namespace murosimf::motion
