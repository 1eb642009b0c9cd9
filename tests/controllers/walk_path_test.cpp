#include "player/walk_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "puppet.h"

namespace murosimf::controllers {
namespace {

/// Walks a puppet towards a pose on the field; the time it took to be within 2 cm and 5 degrees, or -1.
double walkPuppet(const PlanarPose& start, const PlanarPose& goal, double limit) {
  WalkingEngine engine;
  Puppet puppet(start);
  for (int i = 0; i < limit * 100; ++i) {
    const PlanarPose goal_R = between(puppet.pose(), goal);
    if (norm(Point{goal_R.x, goal_R.y}) < 0.02 && std::abs(goal_R.heading) < degrees(5)) return i * 0.01;
    engine.walk(walkTo(goal_R));
    puppet.move(engine.step(0.01, {}, false));
  }
  return -1;
}

TEST(WalkPath, ReachesACommandedPose) {
  const double ahead = walkPuppet({}, {1, 0, 0}, 30);
  EXPECT_GT(ahead, 4.0);  // no faster than it can walk
  EXPECT_LT(ahead, 11.0);
  for (const PlanarPose& goal : {PlanarPose{-0.8, 0, 0}, PlanarPose{0.3, -1.2, 2}, PlanarPose{0.1, 0.1, -1},
                                 PlanarPose{-1.5, 1.0, 3}, PlanarPose{0, 0.2, 0}}) {
    EXPECT_GT(walkPuppet({}, goal, 30), 0) << goal.x << " " << goal.y;
  }
}

TEST(WalkPath, KeepsItsDistanceFromAnObstacleInTheWay) {
  WalkingEngine engine;
  Puppet puppet;
  const Point obstacle{0.7, 0.02};
  const PlanarPose goal{1.5, 0, 0};
  double closest = 10;
  for (int i = 0; i < 2500; ++i) {
    const PlanarPose goal_R = between(puppet.pose(), goal);
    const std::array<Point, 1> seen{transformedBack(puppet.pose(), obstacle)};
    const Point way = detour({goal_R.x, goal_R.y}, seen, 0.32, 0);
    engine.walk(walkTo({way.x, way.y, goal_R.heading}));
    puppet.move(engine.step(0.01, {}, false));
    closest = std::min(closest, norm(seen[0]));
  }
  EXPECT_GT(closest, 0.22);
  EXPECT_LT(norm(Point{puppet.pose().x - 1.5, puppet.pose().y}), 0.05);
}

TEST(WalkPath, ObstacleAtTheTargetDoesNotCount) {
  const std::array<Point, 1> there{Point{0.8, 0.1}};
  const Point way = detour({0.9, 0}, there, 0.32, 0.35);
  EXPECT_EQ(way.x, 0.9);
  EXPECT_EQ(way.y, 0.0);
}

TEST(WalkPath, WayAroundLeadsRoundTheCircleOnTheShorterSide) {
  // The robot at the origin, the centre ahead, the target behind the centre a little to the left.
  Point robot{0, 0};
  const Point centre{0.5, 0}, target{0.8, 0.1};
  double closest = 10, length = 0;
  for (int i = 0; i < 400; ++i) {
    const Point way = wayAround(centre - robot, 0.26, target - robot);
    const double distance = norm(way);
    if (distance < 1e-6) break;
    const double step = std::min(0.01, distance);
    robot = robot + (step / distance) * way;
    length += step;
    closest = std::min(closest, norm(centre - robot));
    if (norm(target - robot) < 1e-3) break;
  }
  EXPECT_LT(norm(target - robot), 0.01);
  EXPECT_GT(closest, 0.25);
  EXPECT_LT(length, 1.1);
}

TEST(WalkPath, WayAroundIsStraightWhereNothingIsInTheWay) {
  const Point target{0.2, 0.3};
  const Point way = wayAround({0.5, 0}, 0.26, target);
  EXPECT_EQ(way.x, target.x);
  EXPECT_EQ(way.y, target.y);
}

}  // namespace
}  // namespace murosimf::controllers
