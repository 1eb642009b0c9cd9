// Levels of detail exchanged while robots walk.

#include "simulation/walkers.h"

namespace murosimf::test {
namespace {

double headingOf(const Pose& X) { return atan2(X.rotation.x.y, X.rotation.x.x); }

TEST(Exchange, KeepsPositionsAndTheBaseVelocityOfTheWalk) {
  Walkers w(walkers(1));
  for (int i = 0; i < 3000; ++i) w.frame();
  for (const int level : {1, 2, 0, 2, 1, 0}) {
    const Pose before = w.base(0);
    const std::vector<double> q = w.joints(0);
    w.simulation().linked().exchange(w.robot(0), level);
    const Pose after = w.base(0);
    EXPECT_LT(norm(after.translation - before.translation), 1e-9) << level;
    EXPECT_NEAR(headingOf(after), headingOf(before), 1e-9) << level;
    EXPECT_EQ(w.joints(0), q) << level;
    for (int i = 0; i < 1500; ++i) w.frame();
  }
}

class ExchangeTo : public testing::TestWithParam<int> {};

TEST_P(ExchangeTo, GivesAWalkingRobotTheMomentumOfItsKinematicWalk) {
  Walkers w(walkers(1));
  for (int i = 0; i < 3000; ++i) w.frame();
  const Pose last = w.base(0);
  for (int i = 0; i < 10; ++i) w.frame();
  const Vector3 mean = (w.base(0).translation - last.translation) * 100;
  w.simulation().interventions().exchangeLevel(w.simulation().frame(), w.robot(0), GetParam());
  w.frame();
  const auto V = w.simulation().linked().handle(w.robot(0), kBaseVelocity).get();
  EXPECT_LT(norm(w.base(0).rotation * V.v - mean), 0.05);
  EXPECT_GT(norm(mean), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Levels, ExchangeTo, testing::Values(1, 2));

TEST(Exchange, KeepsTheBaseVelocityBetweenDynamicLevels) {
  Walkers w(walkers(1));
  for (int i = 0; i < 2000; ++i) w.frame();
  w.simulation().linked().exchange(w.robot(0), 1);
  for (const int level : {2, 1}) {
    for (int i = 0; i < 700; ++i) w.frame();
    const auto V = w.simulation().linked().handle(w.robot(0), kBaseVelocity).get();
    w.simulation().interventions().exchangeLevel(w.simulation().frame(), w.robot(0), level);
    w.simulation().interventions().apply(w.simulation().frame());
    EXPECT_EQ(w.simulation().linked().levelOf(w.robot(0)), level);
    const auto after = w.simulation().linked().handle(w.robot(0), kBaseVelocity).get();
    EXPECT_EQ(after.w, V.w) << level;
    EXPECT_EQ(after.v, V.v) << level;
  }
}

TEST(Exchange, TellsOthersTheMethodsOfTheNewLevel) {
  Walkers w(walkers(1));
  for (int i = 0; i < 10; ++i) w.frame();
  LinkedWorld& linked = w.simulation().linked();
  for (const int level : {1, 2, 1, 0, 2}) {
    linked.exchange(w.robot(0), level);
    const Handle<double> joints_yield = linked.handle(w.robot(0), kJointsYield);
    const Handle<StepManner> manner = linked.handle(w.robot(0), kStepManner);
    EXPECT_EQ(joints_yield.valid(), level > 0);
    if (level == 0) continue;
    EXPECT_EQ(joints_yield.get(), level == 2 ? 1 : 0);
    EXPECT_EQ(manner.get().end_velocity_share, level == 2 ? 1 : 0.5) << "implicit Euler, momentum midpoint";
  }
}

TEST(Exchange, TenTimesInAWalkDoesNotMakeARobotFall) {
  Walkers w(walkers(1));
  for (int i = 0; i < 2500; ++i) w.frame();
  const double start = w.base(0).translation.x;
  for (int k = 0; k < 10; ++k) {
    w.simulation().interventions().exchangeLevel(w.simulation().frame() + 3 * k, w.robot(0), (k + 1) % 3);
    for (int i = 0; i < 800; ++i) w.frame();
    EXPECT_GT(w.base(0).rotation.z.z, 0.97) << k;
  }
  EXPECT_NEAR(w.base(0).translation.x - start, 8 * 0.12, 0.1);
}

TEST(Exchange, LeavesTheBitsOfThoseWhoAreNotExchanged) {
  Walkers with(walkers(3)), without(walkers(3));
  for (int i = 0; i < 2000; ++i) {
    if (i % 37 == 0) with.simulation().interventions().exchangeLevel(i, with.robot(1), (i / 37) % 2);
    with.frame(), without.frame();
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    EXPECT_EQ(with.base(i), without.base(i));
    EXPECT_EQ(with.joints(i), without.joints(i));
  }
  EXPECT_NE(with.base(1), without.base(1));
}

TEST(Exchange, AScenarioSaysFromWhenOnARobotHasWhichMotion) {
  BuiltWorld built("[referee]\nenabled = false\n[ball]\npresent = false\n" + kTwoRobots,
                   {"robots.red.1.motion=multibody_dynamics@0.05, kinematic_walking@0.1"});
  const auto simulation = built.simulation();
  const ObjectId robot = simulation->world().find("robots.red.1");
  std::vector<int> levels;
  for (int i = 0; i < 150; ++i) {
    simulation->step();
    if (i % 50 == 25) levels.push_back(simulation->linked().levelOf(robot));
  }
  EXPECT_EQ(levels, (std::vector<int>{0, 1, 0}));
}

TEST(Exchange, APlanThatNobodyUnderstandsIsRefused) {
  for (const char* plan : {"multibody_dynamics@soon", "kinematic_walking, multibody_dynamics",
                           "multibody_dynamics@2, "
                           "kinematic_walking@1",
                           "@3", "kinematic_walking,,multibody_dynamics@3"}) {
    BuiltWorld built("[robots.red.1]\nfile = \"robots/ks21.urdf\"\npose = [0, 0, 0]\nmotion = \"" + std::string(plan) +
                     "\"\n");
    const auto said = built.complaints();
    ASSERT_FALSE(said.empty()) << plan;
    EXPECT_NE(said[0].find("expected a motion, then others with rising times in seconds"), std::string::npos)
        << said[0];
  }
}

TEST(Exchange, InTheFrameOfAPlacementDoesNotLoseIt) {
  for (const int level : {1, 2}) {
    Walkers one(walkers(1));
    for (int i = 0; i < 100; ++i) one.frame();
    one.simulation().interventions().placeRobot(100, one.robot(0), {1.5, -0.8, 0.3});
    one.simulation().interventions().exchangeLevel(100, one.robot(0), level);
    for (int i = 0; i < 3; ++i) one.frame();
    EXPECT_NEAR(one.base(0).translation.x, 1.5, 0.05);
    EXPECT_NEAR(one.base(0).translation.y, -0.8, 0.05);
    EXPECT_NEAR(atan2(one.base(0).rotation.x.y, one.base(0).rotation.x.x), 0.3, 0.05);
  }
}

}  // namespace
}  // namespace murosimf::test
