// Kinematic robots do not pass through one another, nor through posts.
#include <gtest/gtest.h>

#include "murosimf/algorithms/blocking.h"
#include "murosimf/math/random.h"

namespace murosimf {
namespace {

constexpr double kUpdate = 0.01;  // [s]

BlockingDisc robot(std::uint64_t name, double x, double y, double dx, double dy = 0, double radius = 0.15) {
  return {name, false, radius, x, y, dx, dy};
}
BlockingDisc post(std::uint64_t name, double x, double y, double radius = 0.05) {
  return {name, true, radius, x, y, 0, 0};
}
double endDistance(const BlockingDisc& a, const BlockingDisc& b) {
  const double x = a.x + a.dx - b.x - b.dx, y = a.y + a.dy - b.y - b.dy;
  return sqrt(x * x + y * y);
}
void apply(std::vector<BlockingDisc>& discs) {
  BlockingRule rule;
  rule.apply(discs, kUpdate);
}
void walkOn(std::vector<BlockingDisc>& discs) {
  for (BlockingDisc& d : discs) d.x += d.dx, d.y += d.dy;
}

TEST(Blocking, HeadOnEachGivesUpInProportionToItsApproach) {
  std::vector<BlockingDisc> discs{robot(1, -0.152, 0, 0.006), robot(2, 0.151, 0, -0.003)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, 0.002, 1e-12);  // the gap of 3 mm is shared 2 : 1
  EXPECT_NEAR(discs[1].dx, -0.001, 1e-12);
  EXPECT_NEAR(endDistance(discs[0], discs[1]), 0.3, 1e-12);
}

TEST(Blocking, StandingRobotIsNotPushed) {
  std::vector<BlockingDisc> discs{robot(1, -0.151, 0, 0.004), robot(2, 0.151, 0, 0)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, 0.002, 1e-12);
  EXPECT_EQ(discs[1].dx, 0);
  EXPECT_EQ(discs[1].dy, 0);
}

TEST(Blocking, ChaserIsHeldToTheSpeedOfTheOneThatFlees) {
  std::vector<BlockingDisc> discs{robot(1, -0.15, 0, 0.004), robot(2, 0.15, 0, 0.001)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, 0.001, 1e-12);
  EXPECT_EQ(discs[1].dx, 0.001);
}

TEST(Blocking, MotionAlongTheOtherStays) {
  std::vector<BlockingDisc> discs{robot(1, -0.15, 0, 0.003, 0.002), robot(2, 0.15, 0, 0)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, 0, 1e-12);
  EXPECT_EQ(discs[0].dy, 0.002);
}

TEST(Blocking, WalkingAlongAndAwayIsFree) {
  std::vector<BlockingDisc> discs{robot(1, -0.15, 0, -0.001, 0.004), robot(2, 0.15, 0, 0, -0.004)};
  const std::vector<BlockingDisc> wanted = discs;
  apply(discs);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(discs[i].dx, wanted[i].dx);
    EXPECT_EQ(discs[i].dy, wanted[i].dy);
  }
}

TEST(Blocking, ThreeInARowStopWithoutOverlap) {
  std::vector<BlockingDisc> discs{robot(1, -0.301, 0, 0.004), robot(2, 0, 0, 0), robot(3, 0.301, 0, -0.004)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, 0.001, 1e-12);
  EXPECT_EQ(discs[1].dx, 0);
  EXPECT_NEAR(discs[2].dx, -0.001, 1e-12);
}

TEST(Blocking, WedgeOfTwoPostsStopsARobot) {
  for (double gap : {0.2, 0.3, 0.39, 0.3999}) {  // posts apart by less than the robot's way through needs
    std::vector<BlockingDisc> discs{robot(1, 0, 0.3, 0.0007, -0.004), post(2, -0.5 * gap, 0), post(3, 0.5 * gap, 0)};
    for (int i = 0; i < 300; ++i) {
      discs[0].dx = 0.0007, discs[0].dy = -0.004;
      apply(discs);
      ASSERT_GE(endDistance(discs[0], discs[1]), 0.2 - 1e-8) << gap;
      ASSERT_GE(endDistance(discs[0], discs[2]), 0.2 - 1e-8) << gap;
      walkOn(discs);
    }
    EXPECT_GT(discs[0].y, 0) << gap;
  }
}

TEST(Blocking, RobotGlidesAroundAPost) {
  std::vector<BlockingDisc> discs{robot(1, -0.3, 0.03, 0.004), post(2, 0, 0)};
  for (int i = 0; i < 400; ++i) {
    discs[0].dx = 0.004, discs[0].dy = 0;
    apply(discs);
    ASSERT_GE(endDistance(discs[0], discs[1]), 0.2 - 1e-9);
    walkOn(discs);
  }
  EXPECT_GT(discs[0].x, 0.3);
}

TEST(Blocking, OverlapAfterATeleportIsPartedSlowlyAndByHalves) {
  std::vector<BlockingDisc> discs{robot(1, -0.05, 0, 0), robot(2, 0.05, 0, 0)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, -0.0025, 1e-12);
  EXPECT_NEAR(discs[1].dx, 0.0025, 1e-12);
  for (int i = 0; i < 60; ++i) {
    apply(discs);
    walkOn(discs);
    for (BlockingDisc& d : discs) d.dx = d.dy = 0;
  }
  EXPECT_NEAR(endDistance(discs[0], discs[1]), 0.3, 1e-8);
}

TEST(Blocking, OverlappedPostStaysAndTwoDiscsOnOneSpotPart) {
  std::vector<BlockingDisc> discs{robot(1, 0.1, 0, 0), post(2, 0, 0)};
  apply(discs);
  EXPECT_NEAR(discs[0].dx, 0.005, 1e-12);
  EXPECT_EQ(discs[1].dx, 0);
  std::vector<BlockingDisc> same{robot(1, 0, 0, 0), robot(2, 0, 0, 0)};
  apply(same);
  EXPECT_NEAR(endDistance(same[0], same[1]), 0.005, 1e-12);
}

std::vector<BlockingDisc> crowd(std::uint64_t seed, double size, int count) {
  const RandomStream dice(seed, "crowd", 0);
  std::vector<BlockingDisc> discs;
  for (std::uint64_t k = 0; discs.size() < static_cast<std::size_t>(count) && k < 4000; ++k) {
    const BlockingDisc d = robot(100 + k, dice.uniform(4 * k, -size, size), dice.uniform(4 * k + 1, -size, size),
                                 dice.uniform(4 * k + 2, -0.01, 0.01), dice.uniform(4 * k + 3, -0.01, 0.01));
    bool free = true;
    for (const BlockingDisc& other : discs) {
      const double x = d.x - other.x, y = d.y - other.y;
      free &= x * x + y * y > 0.3 * 0.3;
    }
    if (free) discs.push_back(d);
  }
  return discs;
}

TEST(Blocking, InACrowdNobodyOverlapsAndNobodyIsFasterThanHeWanted) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<BlockingDisc> discs = crowd(seed, 0.9, 22);
    const std::vector<BlockingDisc> wanted = discs;
    apply(discs);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      ASSERT_LE(discs[i].dx * discs[i].dx + discs[i].dy * discs[i].dy,
                wanted[i].dx * wanted[i].dx + wanted[i].dy * wanted[i].dy + 1e-15);
      for (std::size_t j = 0; j < i; ++j) ASSERT_GE(endDistance(discs[i], discs[j]), 0.3 - 1e-8) << seed;
    }
  }
}

TEST(Blocking, ResultDependsOnNamesNotOnTheOrderOfInput) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    std::vector<BlockingDisc> discs = crowd(seed, 0.8, 18), reversed(discs.rbegin(), discs.rend());
    apply(discs);
    apply(reversed);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const BlockingDisc& other = reversed[discs.size() - 1 - i];
      ASSERT_EQ(discs[i].dx, other.dx);
      ASSERT_EQ(discs[i].dy, other.dy);
    }
  }
}

TEST(Blocking, RobotsThatTouchNobodyAreNotChangedByABitNorDoTheyChangeOthers) {
  int free_robots = 0, blocked_robots = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<BlockingDisc> wanted = crowd(seed, 1.2, 20);
    std::vector<BlockingDisc> discs = wanted;
    apply(discs);
    std::vector<BlockingDisc> without;  // the same crowd without those that were not changed
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      bool touches = false;
      for (std::size_t j = 0; j < discs.size(); ++j) touches |= j != i && endDistance(wanted[i], wanted[j]) < 0.32;
      if (touches) {
        without.push_back(wanted[i]);
        kept.push_back(i);
        ++blocked_robots;
        continue;
      }
      ++free_robots;
      ASSERT_EQ(discs[i].dx, wanted[i].dx);
      ASSERT_EQ(discs[i].dy, wanted[i].dy);
    }
    apply(without);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      ASSERT_EQ(without[k].dx, discs[kept[k]].dx);
      ASSERT_EQ(without[k].dy, discs[kept[k]].dy);
    }
  }
  EXPECT_GT(free_robots, 100);
  EXPECT_GT(blocked_robots, 100);
}

}  // namespace
}  // namespace murosimf
