#include "player/positions.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "player/obstacle_memory.h"
#include "puppet.h"

namespace murosimf::controllers {
namespace {

const Pitch kPitch = Pitch::of(makeRobot().field);

Point anyPlace() { return {0.01 * *rc::gen::inRange(-225, 225), 0.01 * *rc::gen::inRange(-150, 150)}; }

RC_GTEST_PROP(Positions, KeeperStandsInFrontOfItsGoalLine, ()) {
  const Point place = keeperPlace(kPitch, anyPlace());
  RC_ASSERT(place.x > -kPitch.half_length + 0.1);
  RC_ASSERT(place.x < -kPitch.half_length + 0.5);
  RC_ASSERT(std::abs(place.y) < kPitch.half_goal);
}

RC_GTEST_PROP(Positions, SupportersStayOnTheFieldAndOffTheBall, ()) {
  const Point ball = anyPlace(), own = anyPlace();
  for (const Role role : {Role::kDefender, Role::kStriker}) {
    const Point place = supportPlace(kPitch, role, ball, own);
    RC_ASSERT(norm(place - ball) > 0.69);
    RC_ASSERT(std::abs(place.x) < kPitch.half_length);
    RC_ASSERT(std::abs(place.y) < kPitch.half_width);
  }
}

TEST(Positions, DefenderStandsBetweenBallAndOwnGoal) {
  for (const Point& ball : {Point{1, 0.5}, Point{0, -1}, Point{-0.5, 0.8}}) {
    const Point place = supportPlace(kPitch, Role::kDefender, ball, {});
    const Point to_goal = kPitch.ownGoal() - ball, to_place = place - ball;
    EXPECT_LT(std::abs(wrapAngle(direction(to_goal) - direction(to_place))), degrees(5));
    EXPECT_LT(norm(to_place), norm(to_goal));
  }
}

TEST(ObstacleMemory, CarriesSightingsAlongAndForgetsThem) {
  ObstacleMemory memory;
  const std::vector<RobotPercept> seen{{1.0, 0.2}, {1.1, 0.25}, {0, -0.8}};
  memory.observe(seen);
  EXPECT_EQ(memory.places_R().size(), 2u);  // two sightings of one robot
  memory.move({0.5, 0, kPi / 2}, 0.01);
  EXPECT_NEAR(memory.places_R()[0].x, 0.225, 0.01);
  EXPECT_NEAR(memory.places_R()[0].y, -0.55, 0.03);
  for (int i = 0; i < 600; ++i) memory.move({}, 0.01);
  EXPECT_TRUE(memory.places_R().empty());
}

}  // namespace
}  // namespace murosimf::controllers
