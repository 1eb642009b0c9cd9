// Self-localisation in simulated games: a robot walks and sees with errors; seeds are fixed, so results are too.

#include <gtest/gtest.h>

#include <limits>

#include "world_model_arena.h"

namespace murosimf::controllers {
namespace {

constexpr double kDegree = kPi / 180;

struct Errors {
  std::vector<double> position, heading;
};

/// Games of 40 s with feet that slip by up to 12 % and turn by up to 15 % less or more than they say.
template <class Change>
Errors gamesWith(Change change, bool placed = true, int games = 10) {
  Errors errors;
  for (int game = 0; game < games; ++game) {
    Arena arena(game % 2 == 0 ? "red" : "blue", static_cast<std::uint64_t>(100 + game));
    arena.slip = arena.uniform(-0.12, 0.12), arena.turn_slip = arena.uniform(-0.15, 0.15);
    change(arena);
    Localisation localisation;
    localisation.start(arena.robot);
    if (placed) localisation.place(arena.truth);
    play(arena, localisation, 40, [&](const Arena& now) {
      errors.position.push_back(now.positionError(localisation.pose()));
      errors.heading.push_back(now.headingError(localisation.pose()));
    });
  }
  return errors;
}

TEST(Localisation, MedianErrorOfWalkingRobotsIsBelowFiveCentimetresAndTwoDegrees) {
  const Errors errors = gamesWith([](Arena&) {});
  EXPECT_LT(median(errors.position), 0.05);
  EXPECT_LT(quantile(errors.position, 0.9), 0.10);
  EXPECT_LT(median(errors.heading), 2 * kDegree);
  EXPECT_LT(quantile(errors.heading, 0.9), 4 * kDegree);
}

TEST(Localisation, FindsThePoseWithoutBeingTold) {
  const Errors errors = gamesWith([](Arena&) {}, false);
  EXPECT_LT(median(errors.position), 0.05);
  EXPECT_LT(quantile(errors.position, 0.9), 0.10);
}

TEST(Localisation, TwiceTheNoiseAndATenthOfFalsePerceptsLeaveTheMedianBelowATenthOfAMetre) {
  const Errors errors = gamesWith([](Arena& arena) {
    arena.noise.bearing *= 2, arena.noise.distance *= 2;
    arena.noise.line *= 2, arena.noise.line_per_distance *= 2, arena.noise.false_share = 0.1;
  });
  EXPECT_LT(median(errors.position), 0.10);
  EXPECT_LT(median(errors.heading), 5 * kDegree);
}

TEST(Localisation, GlancesFromASwayingBodySuffice) {
  const Errors errors = gamesWith([](Arena& arena) {
    arena.glance_period = 4, arena.head_amplitude = 0.8;  // else the head watches the ball: only near lines are seen
    arena.noise.tilt = arena.uniform(-0.01, 0.01), arena.noise.tilt_sway = 0.015;
  });
  EXPECT_LT(median(errors.position), 0.08);
  EXPECT_LT(quantile(errors.position, 0.9), 0.15);
  EXPECT_LT(median(errors.heading), 3 * kDegree);
}

TEST(Localisation, FeetThatSlipByFortyPercentAreNoticed) {
  const Errors errors = gamesWith([](Arena& arena) { arena.slip = arena.turn_slip = 0.4; });
  EXPECT_LT(quantile(errors.position, 0.9), 0.10);
  EXPECT_LT(quantile(errors.heading, 0.9), 4 * kDegree);
}

TEST(Localisation, BlockedRobotIsNotCarriedAwayByItsOdometry) {
  const Errors errors = gamesWith([](Arena& arena) { arena.blocked = true; });
  EXPECT_LT(quantile(errors.position, 0.9), 0.15);
  EXPECT_LT(quantile(errors.heading, 0.9), 6 * kDegree);
}

TEST(Localisation, FalsePerceptsNeverThrowItAcrossTheField) {
  const Errors errors = gamesWith([](Arena& arena) { arena.noise.false_share = 0.1; });
  EXPECT_LT(quantile(errors.position, 1), 0.5);
  EXPECT_LT(quantile(errors.heading, 1), 30 * kDegree);
}

TEST(Localisation, RobotCarriedAwayFindsItselfAgainWithinFiveSeconds) {
  std::vector<double> recovery;
  for (int game = 0; game < 40; ++game) {
    Arena arena(game % 2 == 0 ? "red" : "blue", static_cast<std::uint64_t>(500 + game));
    Localisation localisation;
    localisation.start(arena.robot);
    localisation.place(arena.truth);
    play(arena, localisation, 5, [](const Arena&) {});
    do arena.truth = {arena.uniform(-2, 2), arena.uniform(-1.3, 1.3), arena.uniform(-kPi, kPi)};
    while (arena.positionError(localisation.pose()) < 0.7);
    const double carried = arena.time;
    double found = -1;
    play(arena, localisation, 12, [&](const Arena& now) {
      const bool right = now.positionError(localisation.pose()) < 0.3 && now.headingError(localisation.pose()) < 0.26;
      found = !right ? -1 : found < 0 ? now.time - carried : found;
    });
    recovery.push_back(found < 0 ? 12 : found);
  }
  EXPECT_LT(median(recovery), 2);
  EXPECT_LT(quantile(recovery, 0.95), 4);
}

TEST(Localisation, GoalColoursTellTheTwoHalvesOfASymmetricFieldApart) {
  for (const char* team : {"red", "blue"}) {
    Arena arena(team, 11);
    arena.speed = 0;
    arena.truth = {1.0, 0.4, 0.2};  // sees the goal attacked
    Localisation localisation;
    localisation.start(arena.robot);
    localisation.place({-1.0, -0.4, 0.2 + kPi});  // told the mirror image, from where the other goal would look alike
    play(arena, localisation, 4, [](const Arena&) {});
    EXPECT_LT(arena.positionError(localisation.pose()), 0.1) << team;
    EXPECT_LT(arena.headingError(localisation.pose()), 5 * kDegree) << team;
  }
}

TEST(Localisation, LinesAloneKeepAPositionThatIsKnown) {
  const Errors errors = gamesWith([](Arena& arena) { arena.noise.missed_share = 1; });
  EXPECT_LT(median(errors.position), 0.10);
  EXPECT_LT(median(errors.heading), 5 * kDegree);
}

TEST(Localisation, ClaimedDeviationGrowsBlindAndShrinksWithSights) {
  Arena arena("red", 5);
  Localisation localisation;
  localisation.start(arena.robot);
  EXPECT_GT(localisation.positionDeviation(), 1.0);
  localisation.place(arena.truth);
  const double placed = localisation.positionDeviation();
  for (int i = 0; i < 1000; ++i) localisation.move(arena.walk());
  const double blind = localisation.positionDeviation();
  EXPECT_GT(blind, 2 * placed);
  EXPECT_GT(localisation.headingDeviation(), 0.1);
  play(arena, localisation, 3, [](const Arena&) {});
  EXPECT_LT(localisation.positionDeviation(), 0.5 * blind);
}

TEST(Localisation, EstimateThatExplainsNothingClaimsLittle) {
  Arena arena("red", 8);
  arena.speed = 0;
  arena.noise.false_share = 0;
  Localisation localisation;
  localisation.start(arena.robot);
  localisation.place(arena.truth);
  play(arena, localisation, 3, [](const Arena&) {});
  EXPECT_LT(localisation.positionDeviation(), 0.05);
  for (int i = 0; i < 5; ++i) {  // a goal of the wrong colour where the robot believes to look at the other
    Percepts percepts;
    percepts.posts.push_back({LandmarkColour::kBlue, 0.2, 1.2 + 0.4 * i, 0.02, 0.05, true});
    localisation.observe(percepts);
  }
  EXPECT_GT(localisation.positionDeviation(), 0.5);
  EXPECT_GT(localisation.headingDeviation(), 0.3);
}

TEST(Localisation, FallWidensTheClaimAndOneLookNarrowsIt) {
  Arena arena("red", 6);
  Localisation localisation;
  localisation.start(arena.robot);
  localisation.place(arena.truth);
  localisation.widen(0.3, 0.8);
  EXPECT_NEAR(localisation.headingDeviation(), sqrt(0.64 + 0.0025), 1e-9);
  arena.truth = {arena.truth.x + 0.2, arena.truth.y - 0.1, arena.truth.heading + 0.7};  // the fall turned it
  play(arena, localisation, 3, [](const Arena&) {});
  EXPECT_LT(arena.positionError(localisation.pose()), 0.15);
  EXPECT_LT(arena.headingError(localisation.pose()), 6 * kDegree);
}

TEST(Localisation, NonsenseNeverMakesANumberThatIsNone) {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300, 0,
                        1e-300};
  Localisation localisation;
  localisation.start(robotOfTeam("blue"));
  for (const double a : bad)
    for (const double b : bad) {
      Percepts percepts;
      percepts.posts.push_back({LandmarkColour::kBlue, a, b, 0.02, 0.1, false});
      percepts.posts.push_back({LandmarkColour::kYellow, 0.1, 2, a, b, false});
      percepts.poles.push_back({LandmarkColour::kBlue, b, a, b, a, true});
      percepts.lines.push_back({a, b, 0});
      percepts.lines.push_back({1, 0.1, a});
      localisation.observe(percepts);
      localisation.move({a, b, 0});
      localisation.move({0, 0, b});
      localisation.place({a, b, a});
      const PlanarPose pose = localisation.pose();
      ASSERT_TRUE(std::isfinite(pose.x + pose.y + pose.heading)) << a << " " << b;
      ASSERT_TRUE(std::isfinite(localisation.positionDeviation() + localisation.headingDeviation())) << a << " " << b;
    }
}

TEST(Localisation, ContinuesWithTheSameBitsAfterLoading) {
  Arena arena("blue", 21);
  Localisation original;
  original.start(arena.robot);
  play(arena, original, 6, [](const Arena&) {});
  arena.truth = {0.5, -0.6, 2};  // amid a recovery: several hypotheses, memory full
  play(arena, original, 0.6, [](const Arena&) {});

  client::StateArchive saved;
  original.archive(saved);
  Localisation restored;
  restored.start(arena.robot);
  client::StateArchive loading(saved.bytes());
  restored.archive(loading);
  EXPECT_TRUE(loading.exhausted());
  for (int i = 0; i < 1500; ++i) {
    const PlanarPose odometry = arena.walk();
    original.move(odometry), restored.move(odometry);
    if (!arena.looks()) continue;
    const Percepts percepts = arena.look();
    original.observe(percepts), restored.observe(percepts);
    ASSERT_EQ(original.pose(), restored.pose());
    ASSERT_EQ(original.positionDeviation(), restored.positionDeviation());
  }
  client::StateArchive one, other;
  original.archive(one), restored.archive(other);
  EXPECT_EQ(one.bytes(), other.bytes());
}

}  // namespace
}  // namespace murosimf::controllers
