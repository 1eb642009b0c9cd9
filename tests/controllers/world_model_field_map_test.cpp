// The map of the field: what stands where, and which line a point belongs to.

#include <gtest/gtest.h>

#include "world_model_arena.h"

namespace murosimf::controllers {
namespace {

FieldMap mapOf(const std::string& team) {
  FieldMap map;
  map.start(robotOfTeam(team));
  return map;
}

TEST(FieldMap, BothTeamsAttackTowardsPlusXAndHaveThePoleOfThatColourOnTheirLeft) {
  for (const char* team : {"red", "blue"}) {
    const FieldMap map = mapOf(team);
    const LandmarkColour attacked = team[0] == 'r' ? LandmarkColour::kYellow : LandmarkColour::kBlue;
    const LandmarkColour defended = team[0] == 'r' ? LandmarkColour::kBlue : LandmarkColour::kYellow;
    for (const Point& post : map.landmarks(LandmarkKind::kPost, attacked)) EXPECT_EQ(post.x, 2.25);
    for (const Point& post : map.landmarks(LandmarkKind::kPost, defended)) EXPECT_EQ(post.x, -2.25);
    EXPECT_EQ(map.landmarks(LandmarkKind::kPole, attacked)[0].y, 1.5);
    EXPECT_EQ(map.landmarks(LandmarkKind::kPole, defended)[0].y, -1.5);
  }
}

TEST(FieldMap, InnerFacesOfThePostsAreTheGoalsWidthApart) {
  const FieldMap map = mapOf("red");
  const auto posts = map.landmarks(LandmarkKind::kPost, LandmarkColour::kYellow);
  EXPECT_NEAR(posts[0].y - posts[1].y - 2 * 0.05, 1.5, 1e-12);
}

TEST(FieldMap, FieldWithoutPolesHasNone) {
  client::RobotDescription robot = robotOfTeam("red");
  robot.field.pole_height = 0;
  FieldMap map;
  map.start(robot);
  EXPECT_TRUE(map.landmarks(LandmarkKind::kPole, LandmarkColour::kBlue).empty());
}

TEST(FieldMap, PointBelongsToTheNearestLineOfItsDirection) {
  const FieldMap map = mapOf("red");
  const LineMatch side = map.nearestLine({1.2, 1.45}, {0, 1});
  ASSERT_TRUE(side.found);
  EXPECT_NEAR(side.offset, -0.05, 1e-12);
  EXPECT_EQ(side.normal.y, 1);
  // The same place, seen with the direction of a line along y: the halfway line is the nearest but for the goal line.
  const LineMatch along_y = map.nearestLine({1.2, 1.45}, {-1, 0});
  ASSERT_TRUE(along_y.found);
  EXPECT_NEAR(along_y.offset, 1.2 - 2.25, 1e-12);
}

TEST(FieldMap, OffsetFromTheCentreCircleIsRadial) {
  const LineMatch match = mapOf("red").nearestLine({0.4, 0.4}, {sqrt(0.5), sqrt(0.5)});
  ASSERT_TRUE(match.found);
  EXPECT_NEAR(match.offset, 0.4 * sqrt(2.0) - 0.6, 1e-12);
  EXPECT_NEAR(match.normal.x, sqrt(0.5), 1e-12);
}

TEST(FieldMap, LinesEndWhereTheyArePainted) {
  const FieldMap map = mapOf("red");
  const LineMatch area = map.nearestLine({1.66, 1.0}, {1, 0});  // front line of the goal area: x 1.65, |y| <= 1.05
  EXPECT_NEAR(area.offset, 0.01, 1e-12);
  const LineMatch beyond = map.nearestLine({1.66, 1.3}, {1, 0});
  EXPECT_NEAR(beyond.offset, 1.66 - 2.25, 1e-12);
}

TEST(FieldMap, GradientOfTheOffsetIsItsNormal) {
  const FieldMap map = mapOf("blue");
  const double h = 1e-6;
  for (const Point& p : {Point{0.3, -0.4}, Point{2.1, 0.3}, Point{-1.0, -1.4}, Point{0.55, 0.1}}) {
    for (const Point& direction : {Point{1, 0}, Point{0, 1}, Point{0.6, 0.8}}) {
      const LineMatch match = map.nearestLine(p, direction);
      if (!match.found) continue;
      const double dx = (map.nearestLine({p.x + h, p.y}, direction).offset - match.offset) / h;
      const double dy = (map.nearestLine({p.x, p.y + h}, direction).offset - match.offset) / h;
      EXPECT_NEAR(dx, match.normal.x, 1e-5);
      EXPECT_NEAR(dy, match.normal.y, 1e-5);
    }
  }
}

}  // namespace
}  // namespace murosimf::controllers
