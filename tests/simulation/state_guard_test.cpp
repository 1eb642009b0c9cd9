// A robot whose state is no number any more stands still; the others do not notice.

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/simulation/checkpoint.h"
#include "simulation/walkers.h"

namespace murosimf::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void spoil(Walkers& all, std::size_t robot) {
  all.simulation().linked().handle(all.robot(robot), kJointVelocity, subset::kJoints).set(kNaN, 3);
}

/// Walkers at one of their levels, after a second.
Walkers atLevel(int level) {
  Walkers all(walkers(3, 2));
  for (std::size_t i = 0; i < 3; ++i) all.simulation().interventions().exchangeLevel(0, all.robot(i), level);
  for (int i = 0; i < 1000; ++i) all.frame();
  return all;
}

class StateGuardAt : public testing::TestWithParam<int> {};

TEST_P(StateGuardAt, ARobotWhoseStateIsNoNumberIsFrozenAndTheOthersKeepTheirBits) {
  Walkers healthy = atLevel(GetParam()), spoilt = atLevel(GetParam());
  std::vector<Pose> last;
  for (int i = 0; i < 5; ++i) {  // of the last five steps one is kept, at least
    healthy.frame(), spoilt.frame();
    last.push_back(spoilt.base(1));
  }
  spoil(spoilt, 1);
  for (int i = 0; i < 500; ++i) healthy.frame(), spoilt.frame();
  const StateGuard& guard = spoilt.simulation().guard();
  for (const std::size_t other : {0U, 2U}) {
    EXPECT_EQ(healthy.base(other), spoilt.base(other));
    EXPECT_EQ(healthy.joints(other), spoilt.joints(other));
    EXPECT_FALSE(guard.frozen(other));
  }
  if (guard.faults().empty()) {
    EXPECT_EQ(GetParam(), 0) << "only motion that overwrites its velocities gets over it";
    return;
  }
  ASSERT_EQ(guard.faults().size(), 1U);
  EXPECT_TRUE(guard.frozen(1));
  const Vector3 held = spoilt.base(1).translation;
  EXPECT_TRUE(std::any_of(last.begin(), last.end(), [&](const Pose& X_WB) {
    return norm(held - X_WB.translation) < 1e-5;  // kept in single precision
  }));
  EXPECT_EQ(guard.faults()[0].steps.size(), 200U);
  EXPECT_NE(guard.faults()[0].what.find("is nan"), std::string::npos) << guard.faults()[0].what;
  EXPECT_EQ(healthy.simulation().guard().faults().size(), 0U);
}

TEST_P(StateGuardAt, WhoeverIsPlacedMovesAgain) {
  Walkers all = atLevel(GetParam());
  all.simulation().linked().handle(all.robot(1), kBasePose).set({Rotation<>{}, {kNaN, 0, 0}});
  all.simulation().linked().handle(all.robot(1), kJointPosition, subset::kJoints).set(kNaN, 0);
  for (int i = 0; i < 20; ++i) all.frame();
  ASSERT_TRUE(all.simulation().guard().frozen(1)) << "level " << GetParam();
  const Pose held = all.base(1);
  for (int i = 0; i < 100; ++i) all.frame();
  EXPECT_EQ(all.base(1), held);
  all.simulation().interventions().placeRobot(0, all.robot(1), {1, 3, 0});
  for (int i = 0; i < 1000; ++i) all.frame();
  EXPECT_FALSE(all.simulation().guard().frozen(1));
  EXPECT_NEAR(all.base(1).translation.y, 3, 0.3);
  EXPECT_GT(std::abs(all.base(1).translation.x - 1), 1e-3) << "it was to walk";
  EXPECT_GT(all.base(1).rotation.z.z, 0.9);
}

INSTANTIATE_TEST_SUITE_P(Levels, StateGuardAt, testing::Values(0, 1, 2));

TEST(StateGuard, AFrozenRobotStaysWhereItIsWhenItsLevelIsExchanged) {
  Walkers all = atLevel(2);
  spoil(all, 1);
  all.frame();
  ASSERT_TRUE(all.simulation().guard().frozen(1));
  const Pose held = all.base(1);
  for (const int level : {0, 1, 2}) {
    all.simulation().interventions().exchangeLevel(0, all.robot(1), level);
    for (int i = 0; i < 50; ++i) all.frame();
    EXPECT_EQ(all.base(1), held) << "level " << level;
  }
}

TEST(StateGuard, ExplicitStepsThatAreTooLongEndInAFrozenRobotAndNotInNumbersThatAreNone) {
  BuiltWorld built(walkers(2, 2), {"robots.all.motion=multibody_dynamics", "robots.red.2.integration=explicit_euler",
                                   "simulation.frame=0.005"});
  const auto simulation = built.simulation();
  for (int i = 0; i < 1000 && simulation->guard().faults().empty(); ++i) simulation->step();
  ASSERT_EQ(simulation->guard().faults().size(), 1U);
  EXPECT_TRUE(simulation->guard().frozen(1));
  const Pose held = simulation->linked().handle(simulation->participants().robots[1], kBasePose).get();
  EXPECT_TRUE(std::isfinite(norm(held.translation)));
}

}  // namespace
}  // namespace murosimf::test
