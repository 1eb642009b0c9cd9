// A four-legged robot trots, on multibody dynamics and on both versions of simplified dynamics.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "modules/trotting_robots.h"

namespace murosimf::motion {
namespace {

struct TrotLevel {
  const char* name;
  DynamicLevel level;
};
class RappeTrot : public testing::TestWithParam<TrotLevel> {};

TEST_P(RappeTrot, GoesThreeMetresStraightWithItsTrunkLevel) {
  TrottingRobots trotting({"0.4 0 0"}, GetParam().level);
  double lowest = 1, highest = 0, upright = 1;
  trotting.run(9.5, [&] {
    const Pose X_WB = trotting.base();
    lowest = std::min(lowest, X_WB.translation.z), highest = std::max(highest, X_WB.translation.z);
    upright = std::min(upright, X_WB.rotation.z.z);
  });
  const Pose end = trotting.base();
  EXPECT_GT(end.translation.x, 3);
  EXPECT_LT(std::fabs(end.translation.y), 0.15);
  EXPECT_LT(std::fabs(headingOf(end)), 0.06);
  EXPECT_GT(lowest, 0.30);
  EXPECT_LT(highest, 0.335);
  EXPECT_GT(upright, std::cos(4 * kPi / 180));
}

// Servos give way: knees that take up the load let the hooves slip forward by 7 mm, and the robot back, every step.
TEST_P(RappeTrot, GoesNearlyAsFastAsCommandedInEveryDirection) {
  const auto speed = [&](const std::string& plan) {
    TrottingRobots trotting({plan}, GetParam().level);
    trotting.run(3);
    const Pose begin = trotting.base();
    trotting.run(4);
    const Pose X = inverse(begin) * trotting.base();
    EXPECT_GT(trotting.base().rotation.z.z, 0.99) << plan;
    return Vector3{X.translation.x / 4, X.translation.y / 4, headingOf(X) / 4};
  };
  EXPECT_NEAR(speed("0.5 0 0").x, 0.5, 0.1);
  EXPECT_NEAR(speed("-0.2 0 0").x, -0.2, 0.08);
  EXPECT_NEAR(speed("0 0.15 0").y, 0.15, 0.04);
  EXPECT_NEAR(speed("0 0 0.6").z, 0.6, 0.04);
}

TEST_P(RappeTrot, StandsStillAsLongAsItIsToldNothing) {
  TrottingRobots trotting({"", "0.3 0 0, 0 0 0@2"}, GetParam().level);
  trotting.run(5);
  const Pose begin[] = {trotting.base(0), trotting.base(1)};
  trotting.run(2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(norm(trotting.base(i).translation - begin[i].translation), 2e-3) << i;
    EXPECT_EQ(std::string(trotting.program(i).report().activity), "stand");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Levels, RappeTrot,
    testing::Values(TrotLevel{"multibody", multibody()}, TrotLevel{"multibody_smooth", multibody("smooth_contact")},
                    TrotLevel{"simplified_two", simplified()},
                    TrotLevel{"simplified_one", simplified().with("simplified_dynamics.recompute", 0)}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(RappeTrotLanes, EqualScalarBitForBit) {
  const std::vector<std::string> plans{"0.4 0 0", "0 0.1 0.5", "-0.2 0 0", ""};
  for (const DynamicLevel& level : {multibody(), simplified()}) {
    for (const int lanes : {4, 8}) {
      TrottingRobots together(plans, level, lanes);
      together.run(1.5);
      for (std::size_t i = 0; i < plans.size(); ++i) {
        TrottingRobots alone({plans[i]}, level, 1, i);
        alone.run(1.5);
        const Pose a = together.base(i), b = alone.base();
        EXPECT_EQ(std::memcmp(&a, &b, sizeof(Pose)), 0) << lanes << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace murosimf::motion
