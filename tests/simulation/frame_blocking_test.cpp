// Kinematic robots in each other's way.

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/walking_team.h"

namespace murosimf::team {
namespace {

constexpr double kReach = 0.28;  // sum of two blocking radii [m]

double distance(const Pose& a, const Pose& b) {
  return std::hypot(a.translation.x - b.translation.x, a.translation.y - b.translation.y);
}

TEST(Blocking, TwoRobotsThatWalkIntoEachOtherStopAndDoNotOverlap) {
  WalkingTeam team(
      {{"robots.red.1", {-0.6, 0, 0}, {0.2, 0, 0}, 0}, {"robots.blue.1", {0.6, 0.02, kPi}, {0.2, 0, 0}, 0.3}},
      {.ball = false});
  double nearest = 9;
  for (int i = 0; i < 6000; ++i) {
    team.frame();
    nearest = min(nearest, distance(team.base(0), team.base(1)));
  }
  EXPECT_GT(nearest, kReach - 0.001);  // the rule looks one step ahead; the gait may change its speed in that step
  EXPECT_LT(distance(team.base(0), team.base(1)), kReach + 0.02);
}

TEST(Blocking, WhoIsStoppedDoesNotJitter) {
  WalkingTeam team({{"robots.red.1", {-0.6, 0, 0}, {0.2, 0, 0}, 0}, {"robots.blue.1", {0.6, 0, kPi}, {0.2, 0, 0}, 0.3}},
                   {.ball = false});
  team.frames(5000);
  Vector3 last[2] = {team.base(0).translation, team.base(1).translation}, last_velocity[2];
  double jerkiest = 0;
  for (int i = 0; i < 200; ++i) {
    team.frames(10);
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3 now = team.base(k).translation, velocity = (now - last[k]) * 100;
      if (i > 0) jerkiest = max(jerkiest, std::hypot(velocity.x - last_velocity[k].x, velocity.y - last_velocity[k].y));
      last[k] = now, last_velocity[k] = velocity;
    }
  }
  // A walking robot's base changes its speed by up to .05 m/s in 10 ms; blocked ones hardly more.
  EXPECT_LT(jerkiest, 0.1);
}

TEST(Blocking, AStandingRobotIsNotPushedByOneThatWalksIntoIt) {
  WalkingTeam team({{"robots.red.1", {-0.5, 0, 0}, {0.2, 0, 0}, 0}, {"robots.blue.1", {0, 0.05, 0}, {}, 0, 0}},
                   {.ball = false});
  team.frames(100);
  const Pose before = team.base(1);
  team.frames(5000);
  EXPECT_EQ(team.base(1), before);
  EXPECT_GT(distance(team.base(0), team.base(1)), kReach - 0.001);
}

TEST(Blocking, WhoIsNotInTheWayKeepsEveryBit) {
  const Member walker{"robots.red.1", {-1.0, 1.5, 0}, {0.15, 0.02, 0.1}, 0.2};
  WalkingTeam alone({walker}, {.ball = false});
  WalkingTeam crowd(
      {walker, {"robots.red.2", {-0.6, 0, 0}, {0.2, 0, 0}, 0}, {"robots.blue.1", {0.6, 0, kPi}, {0.2, 0, 0}, 0.3}},
      {.lanes = 4, .ball = false});
  for (int i = 0; i < 4000; ++i) {
    alone.frame(), crowd.frame();
    ASSERT_EQ(alone.base(0), crowd.base(0)) << i;
  }
}

TEST(Blocking, TwoRobotsPutIntoOneAnotherPart) {
  WalkingTeam team({{"robots.red.1", {0, 0, 0}, {}, 0}, {"robots.blue.1", {0.1, 0.02, 0}, {}, 0.3}}, {.ball = false});
  team.frames(600);
  EXPECT_GT(distance(team.base(0), team.base(1)), kReach - 0.002);
}

}  // namespace
}  // namespace murosimf::team
