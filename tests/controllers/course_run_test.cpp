// The runner's plan keeps away from obstacles, inside the strip, and on the right side of each pole.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "player/course_memory.h"
#include "player/course_run.h"

namespace murosimf::controllers {
namespace {

client::CourseDescription course(double width, double radius, bool slalom) {
  client::CourseDescription c;
  c.length = 3.6, c.width = width;
  c.obstacle_radius = radius;
  c.slalom = slalom;
  return c;
}

/// The way from the start to the finish line, in steps of 5 cm.
std::vector<Point> wayOf(const WayGrid& grid, double length) {
  std::vector<Point> way{{-0.2, 0}};
  while (way.back().x < length && way.size() < 500) way.push_back(grid.ahead(way.back(), 0.05));
  return way;
}

TEST(WayGrid, GoesStraightWhereNothingStands) {
  WayGrid grid;
  grid.start(course(0, 0.1, false));
  grid.plan({}, {});
  for (const Point& p : wayOf(grid, 3.6)) EXPECT_NEAR(p.y, 0, 0.06);
}

TEST(WayGrid, KeepsAwayFromObstaclesAndInsideTheStrip) {
  WayGrid grid;
  grid.start(course(1.5, 0.2, false));
  const std::vector<Point> boxes{{0.9, 0.0}, {1.8, 0.375}, {2.7, -0.375}, {2.7, 0}};
  grid.plan(boxes, {});
  const std::vector<Point> way = wayOf(grid, 3.6);
  EXPECT_GE(way.back().x, 3.6);
  for (const Point& p : way) {
    EXPECT_LE(std::fabs(p.y), 0.75 - 0.05);
    for (const Point& box : boxes) EXPECT_GT(norm(p - box), 0.2 + 0.15);
  }
}

TEST(WayGrid, CrossesNoWall) {
  for (const bool first_left : {true, false}) {
    WayGrid grid;
    grid.start(course(0, 0.1, true));
    const std::vector<Point> poles{{1.05, 0}, {1.8, 0}, {2.55, 0}};
    std::vector<CourseWall> walls;
    for (std::size_t i = 0; i < 3; ++i) walls.push_back({poles[i], (i % 2 == 0) != first_left});
    grid.plan(poles, walls);
    const std::vector<Point> way = wayOf(grid, 3.6);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto crossing = std::find_if(way.begin(), way.end(), [&](const Point& p) { return p.x >= poles[i].x; });
      ASSERT_NE(crossing, way.end());
      EXPECT_EQ(crossing->y > 0, first_left == (i % 2 == 0)) << i;
      EXPECT_GT(std::fabs(crossing->y), 0.25);
    }
  }
}

TEST(CourseMemory, TakesManySightingsOfOneObstacleForOne) {
  CourseMemory memory;
  memory.start(course(0, 0.1, true));
  for (int i = 0; i < 10; ++i) {
    const std::vector<ObstaclePercept> seen{{1.0 + 0.02 * (i % 3 - 1), 0.03 * (i % 2)}, {1.8, -0.1}};
    memory.observe(seen);
  }
  ASSERT_EQ(memory.places_R().size(), 2U);
  EXPECT_NEAR(memory.places_R()[0].x, 1.0, 0.02);
  memory.move({0.5, 0, kPi / 2});  // ahead by 0.5 m, then turned to the left
  EXPECT_NEAR(memory.places_R()[0].y, -0.5, 0.02);
}

TEST(CourseMemory, BelievesNothingThatWasSeenOnceOnly) {
  CourseMemory memory;
  memory.start(course(0, 0.1, true));
  const std::vector<ObstaclePercept> once{{1.0, 0.2}};
  memory.observe(once);
  EXPECT_TRUE(memory.places_R().empty());
}

}  // namespace
}  // namespace murosimf::controllers
