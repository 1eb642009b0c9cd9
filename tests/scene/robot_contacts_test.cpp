// Robots that touch one another: they recoil, at every level of detail that knows forces.

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "murosimf/simulation/state_hash.h"
#include "scene/touching_robots.h"

namespace murosimf::test {
namespace {

using TwoMotions = std::tuple<const char*, const char*>;
constexpr const char* kDynamic[] = {"multibody_dynamics", "composite_body_dynamics", "simplified_dynamics"};
constexpr const char* kAll[] = {"kinematic_walking", "simplified_dynamics", "multibody_dynamics"};

std::string nameOf(const testing::TestParamInfo<TwoMotions>& test) {
  return std::string(std::get<0>(test.param)) + "_and_" + std::get<1>(test.param);
}

class RobotsInFlight : public testing::TestWithParam<TwoMotions> {};

TEST_P(RobotsInFlight, KeepTheirMomentumWhenTheyCollide) {
  const auto [red, blue] = GetParam();
  Robots two({red, blue});
  two.put(0, {{}, {0, 0, 2}}, {2, 0, 0});
  two.put(1, {rotationZ(0.4), {0.3, 0.03, 2}});
  for (int i = 0; i < 2; ++i) two.simulation().step();  // the first one begins where they stood
  const Vector3 before = two.momentum(0) + two.momentum(1), alone = two.momentum(1);
  for (int i = 0; i < 400; ++i) two.simulation().step();
  const Vector3 after = two.momentum(0) + two.momentum(1);
  EXPECT_GT(two.momentum(1).x - alone.x, 0.5) << "they were to collide";
  EXPECT_NEAR(after.x, before.x, 5e-4 * before.x) << "first order: forces stay in the body's axes over a step";
  EXPECT_NEAR(after.y, before.y, 5e-4 * before.x);
}

INSTANTIATE_TEST_SUITE_P(Levels, RobotsInFlight,
                         testing::Combine(testing::ValuesIn(kDynamic), testing::ValuesIn(kDynamic)), nameOf);

TEST(RobotsInFlight, WhoDoesNotRecoilPushesAndKeepsItsWay) {
  Robots two({"simplified_dynamics", "multibody_dynamics"}, {"robots.red.1.recoil=none"});
  two.put(0, {{}, {0, 0, 2}}, {2, 0, 0});
  two.put(1, {{}, {0.3, 0.03, 2}});
  for (int i = 0; i < 2; ++i) two.simulation().step();
  const double before = two.momentum(0).x;
  for (int i = 0; i < 400; ++i) two.simulation().step();
  EXPECT_NEAR(two.momentum(0).x, before, 1e-6);
  EXPECT_GT(two.momentum(1).x, 1) << "it was to be pushed";
}

TEST(RobotsInFlight, AreSeenOnAnEvenWayWhateverTheLengthOfTheirSteps) {
  for (const char* period : {"0.001", "0.004"}) {
    Robots one({"multibody_dynamics"}, {std::string("robots.all.motion.period=") + period});
    ContactTable table(one.simulation().world());
    std::vector<SharedKind> known;
    ContactRobot seen(one.simulation().world(), one.simulation().linked(), one.robot(0), table, known);
    one.put(0, {{}, {0, 0, 5}}, {2, 0, 0});
    for (int i = 0; i < 16; ++i) one.simulation().step();
    double last = 0;
    for (int i = 0; i < 16; ++i) {
      seen.begin(one.simulation().frame(), one.simulation().frameLength());
      const double x = seen.basePosition().x;
      const double way = i > 0 ? x - last : 2e-3;
      EXPECT_NEAR(way, 2e-3, 1e-5) << period << " frame " << i;
      last = x;
      one.simulation().step();
    }
  }
}

class RobotIntoRobot : public testing::TestWithParam<TwoMotions> {};

TEST_P(RobotIntoRobot, PutThereByAHandPartsSlowly) {
  const auto [red, blue] = GetParam();
  Robots two({red, blue});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 10; ++k) {
    const PlanarPose place{0.1 * number(random), 0.1 * number(random), kPi * number(random)};
    two.place(0, {0, 0, 0});
    two.place(1, place);
    double fastest = 0;
    for (int i = 0; i < 300; ++i) {
      two.simulation().step();
      fastest = std::max(fastest, two.fastest());
    }
    EXPECT_LT(fastest, 4) << k << ": " << place.x << " " << place.y << " " << place.heading;
  }
  EXPECT_TRUE(two.simulation().guard().faults().empty());
}

INSTANTIATE_TEST_SUITE_P(Levels, RobotIntoRobot, testing::Combine(testing::ValuesIn(kAll), testing::ValuesIn(kAll)),
                         nameOf);

/// A crowd that pushes, of all levels of detail and with two integrators.
std::string crowd() {
  const char* const settings[] = {
      "level = \"full\"",      "level = \"fast\"", "level = \"full\"\nintegration = \"midpoint\"",
      "level = \"kinematic\"", "level = \"full\"", "level = \"fast\""};
  std::string text = kQuietGame;
  for (int i = 0; i < 6; ++i) {
    text += fmt::format("[robots.red.{}]\npose = [{}, {}, {}]\n{}\n", i + 1, 0.17 * (i % 3), i < 3 ? 0.0 : 0.18,
                        0.9 * i, settings[i]);
  }
  return text;
}

/// Its state after half a second.
std::uint64_t crowdOf(const std::string& lanes) {
  BuiltWorld built(crowd(), {"simulation.lanes=" + lanes});
  const auto simulation = built.simulation();
  long touched = 0;
  for (int i = 0; i < 500; ++i) {
    simulation->step();
    touched += simulation->pairs().counts().found;
  }
  EXPECT_GT(touched, 500);
  return simulation->stateHash();
}

TEST(RobotCrowd, HasTheSameBitsInLanesOfAnyWidth) {
  const std::uint64_t alone = crowdOf("1");
  EXPECT_EQ(alone, crowdOf("4"));
  EXPECT_EQ(alone, crowdOf("8"));
}

TEST(RobotCrowd, GoesOnFromACheckpointWithTheSameBits) {
  BuiltWorld built(crowd()), other(crowd());
  const auto simulation = built.simulation(), restored = other.simulation();
  for (int i = 0; i < 250; ++i) simulation->step();
  StateArchive saved;
  simulation->archive(saved);
  StateArchive loaded(saved.bytes());
  restored->archive(loaded);
  for (int i = 0; i < 250; ++i) simulation->step(), restored->step();
  EXPECT_EQ(simulation->stateHash(), restored->stateHash());
}

TEST(RobotHeap, OfTenLimpRobotsCalmsDown) {
  Robots ten(std::vector<std::string>(10, "multibody_dynamics"));
  for (std::size_t i = 0; i < ten.count(); ++i) {
    const double n = static_cast<double>(i);
    ten.put(i, {rotationExp(Vector3{n, 0.5 * static_cast<double>(i % 3), 0}),
                {0.05 * static_cast<double>(i % 3), 0.04 * static_cast<double>(i % 4), 0.4 + 0.5 * n}});
  }
  for (int i = 0; i < 13000; ++i) ten.simulation().step();
  for (std::size_t i = 0; i < ten.count(); ++i) EXPECT_LT(ten.kineticEnergy(i), 3e-4) << i << " [J]";
  EXPECT_LT(ten.deepest(), 1e-3);
  EXPECT_GT(ten.simulation().pairs().counts().found, 10);
  EXPECT_TRUE(ten.simulation().guard().faults().empty());
}

}  // namespace
}  // namespace murosimf::test
