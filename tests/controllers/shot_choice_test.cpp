#include "player/shot_choice.h"

#include <gtest/gtest.h>

#include "puppet.h"

namespace murosimf::controllers {
namespace {

const Pitch kPitch = Pitch::of(makeRobot().field);

ShotChoice shotFrom(const Point& ball, std::vector<Point> robots = {}) {
  ShotChoice shot;
  shot.evaluate(kPitch, ball, robots);
  return shot;
}
double toGoal(const Point& ball) { return direction(kPitch.attackedGoal() - ball); }

TEST(ShotChoice, ShootsAtOnceWhenTheGoalIsInLine) {
  const ShotChoice shot = shotFrom({1.2, 0.1});
  EXPECT_DOUBLE_EQ(shot.best(degrees(3)), degrees(3));
}

TEST(ShotChoice, TurnsUntilTheGoalIsInLine) {
  const Point ball{1.2, 0.6};
  const double chosen = shotFrom(ball).best(degrees(60));
  EXPECT_GT(shotFrom(ball).value(chosen), 0.6 * ShotChoice::kGoalValue);
  EXPECT_LT(std::abs(wrapAngle(chosen - toGoal(ball))), degrees(35));
}

TEST(ShotChoice, NeverPlaysTowardsTheOwnGoal) {
  for (const double y : {-1.2, -0.3, 0.0, 0.4, 1.3}) {
    const Point ball{-1.9, y};
    for (int present = -180; present < 180; present += 10) {
      const double chosen = shotFrom(ball).best(degrees(present));
      EXPECT_GT(cos(chosen), 0.1) << y << " " << present;  // away from the goal line that the team defends
    }
  }
}

TEST(ShotChoice, PlaysPastARobotInTheWay) {
  const Point ball{1.0, 0}, robot{1.9, 0};
  const ShotChoice open = shotFrom(ball), blocked = shotFrom(ball, {robot});
  EXPECT_LT(blocked.value(0), open.value(0) - 1);
  const double chosen = blocked.best(0);
  EXPECT_GT(std::abs(chosen), degrees(10));
  EXPECT_GT(blocked.value(chosen), blocked.value(0));
}

TEST(ShotChoice, IsSymmetricAboutTheFieldsLongAxis) {
  const ShotChoice left = shotFrom({0.7, 0.9}), right = shotFrom({0.7, -0.9});
  for (int i = -180; i < 180; i += 5) EXPECT_NEAR(left.value(degrees(i)), right.value(degrees(-i)), 1e-9);
}

}  // namespace
}  // namespace murosimf::controllers
