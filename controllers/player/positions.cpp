#include "positions.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

namespace {

constexpr double kArc = 0.40;                        // the keeper's distance from the goal's centre [m]
constexpr double kLineDistance = 0.15;               // at least this far before the goal line [m]
constexpr double kZoneDepth = 0.9, kZoneSide = 0.3;  // keeper's zone: depth, beyond the posts [m]
constexpr double kDistance = 0.7;                    // of supporters from the ball [m]
constexpr double kWing = 0.45;                       // of a wing's home from the middle, over half the field's width

/// p, moved away from the ball to the distance that leaves it to the team mate there.
Point apartFromBall(const Point& p, const Point& ball_F) {
  const Point away = p - ball_F;
  const double distance = norm(away);
  if (distance >= kDistance) return p;
  const double side = ball_F.y > 0 ? -1.0 : 1.0;  // towards the middle of the field when p is no help
  return distance > 0.05 ? ball_F + (kDistance / distance) * away : ball_F + Point{0, side * kDistance};
}

Point inside(const Pitch& pitch, const Point& p) {
  const double x = pitch.half_length - 0.35, y = pitch.half_width - 0.25;
  return {clamp(p.x, -x, x), clamp(p.y, -y, y)};
}

}  // namespace

Point homePlace(const Pitch& pitch, Role role, int wing) {
  const double side = kWing * pitch.half_width * wing;
  switch (role) {
    case Role::kKeeper:
      return {-pitch.half_length + 0.25, 0};
    case Role::kDefender:
      return {-0.45 * pitch.half_length, wing == 0 ? 0.15 * pitch.half_width : side};
    case Role::kStriker:
    case Role::kRunner:
      return {0.1 * pitch.half_length, wing == 0 ? -0.15 * pitch.half_width : side};
  }
  return {};
}

Point keeperPlace(const Pitch& pitch, const Point& ball_F) {
  const Point to_ball = ball_F - pitch.ownGoal();
  const double distance = norm(to_ball);
  if (distance < 1e-6) return homePlace(pitch, Role::kKeeper);
  const double arc = std::min(kArc, 0.5 * distance);
  const Point p = pitch.ownGoal() + (arc / distance) * to_ball;
  const double side = pitch.half_goal - 0.1;
  return {std::max(p.x, -pitch.half_length + kLineDistance), clamp(p.y, -side, side)};
}

Point blockPlace(const Pitch& pitch, const Point& ball_F) {
  const Point to_goal = pitch.ownGoal() - ball_F;
  const double distance = std::max(0.1, norm(to_goal));
  return ball_F + (std::min(kDistance, 0.5 * distance) / distance) * to_goal;
}

bool inKeeperZone(const Pitch& pitch, const Point& ball_F, double margin) {
  return ball_F.x < -pitch.half_length + kZoneDepth + margin &&
         std::fabs(ball_F.y) < pitch.half_goal + kZoneSide + margin;
}

Point supportPlace(const Pitch& pitch, Role role, const Point& ball_F, const Point& own_F, int wing) {
  const double wing_y = kWing * pitch.half_width * wing;
  if (role == Role::kDefender) {
    const Point to_goal = pitch.ownGoal() - ball_F;
    const double distance = std::max(0.1, norm(to_goal));
    const double back = clamp(0.45 * distance, kDistance, 1.6);
    const Point p = ball_F + (back / distance) * to_goal;
    const Point before_goal{std::max(p.x, -pitch.half_length + 0.75),
                            p.y + 0.5 * wing_y};  // leaves the goal to the keeper
    return apartFromBall(inside(pitch, apartFromBall(before_goal, ball_F)), ball_F);
  }
  // Where a kick ends, on the side on which the robot is already, unless the ball is clearly on that side.
  const double side = std::fabs(ball_F.y) > 0.3 ? (ball_F.y > 0 ? -1.0 : 1.0) : (own_F.y > 0 ? 1.0 : -1.0);
  const double beside = wing == 0 ? side * 0.5 : wing_y;
  return apartFromBall(inside(pitch, {ball_F.x + 1.3, 0.5 * ball_F.y + beside}), ball_F);
}

}  // namespace murosimf::controllers
