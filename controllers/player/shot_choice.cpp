#include "shot_choice.h"

#include <algorithm>
#include <cmath>

#include "positions.h"

namespace murosimf::controllers {

namespace {

constexpr double kOutCost = 1.0, kBlockCost = 0.3, kKeeperCost = 0.7, kOwnGoalCost = 10.0;
constexpr double kBodyRadius = 0.13, kBlockDistance = 1.3;  // [m]

/// Way along the unit vector `along` from `from` until the field ends [m].
double wayToEdge(const Pitch& pitch, const Point& from, const Point& along) {
  double way = 1e9;
  if (along.x > 1e-9) way = std::min(way, (pitch.half_length - from.x) / along.x);
  if (along.x < -1e-9) way = std::min(way, (-pitch.half_length - from.x) / along.x);
  if (along.y > 1e-9) way = std::min(way, (pitch.half_width - from.y) / along.y);
  if (along.y < -1e-9) way = std::min(way, (-pitch.half_width - from.y) / along.y);
  return std::max(0.0, way);
}

/// Way along `along` until the ball meets a robot that stands near enough to stop it [m].
double wayToRobot(const Pitch& pitch, const Point& from, const Point& along, std::span<const Point> robots_F) {
  double way = 1e9;
  for (const Point& robot : robots_F) {
    const Point d = robot - from;
    const double ahead = dot(d, along), beside = std::fabs(along.x * d.y - along.y * d.x);
    const bool meets = ahead > 0 && ahead < kBlockDistance && beside < kBodyRadius + pitch.ball_radius;
    if (meets) way = std::min(way, ahead);
  }
  return way;
}

/// Value of one exact kick.
double valueOf(const Pitch& pitch, const Point& ball, const Point& along, std::span<const Point> robots_F) {
  const double edge = wayToEdge(pitch, ball, along), robot = wayToRobot(pitch, ball, along, robots_F);
  const double way = std::min({ShotChoice::kRange, edge, robot});
  const Point end = ball + way * along;
  const double closeness = -norm(pitch.attackedGoal() - end);
  if (way == robot && way < edge) return closeness - kBlockCost;
  if (way < edge) return inKeeperZone(pitch, {-end.x, -end.y}, 0) ? closeness - kKeeperCost : closeness;
  const bool between_posts = std::fabs(end.y) < pitch.half_goal - pitch.post_radius - pitch.ball_radius;
  const bool over_goal_line = std::fabs(end.x) > pitch.half_length - 1e-6;
  if (!over_goal_line || !between_posts) return closeness - kOutCost;
  return end.x > 0 ? ShotChoice::kGoalValue : -kOwnGoalCost;
}

}  // namespace

void ShotChoice::evaluate(const Pitch& pitch, const Point& ball_F, std::span<const Point> robots_F) {
  std::array<double, kDirections> exact{};
  for (int i = 0; i < kDirections; ++i) {
    const SinCos<double> a = sincos(i * kStep);
    exact[index(i)] = valueOf(pitch, ball_F, {a.cos, a.sin}, robots_F);
  }
  constexpr std::array<double, 7> kWeights{1, 3, 5, 6, 5, 3, 1};  // a kick errs by about 7 degrees
  for (int i = 0; i < kDirections; ++i) {
    double sum = 0;
    for (int j = -3; j <= 3; ++j) sum += kWeights[static_cast<std::size_t>(j + 3)] * exact[index(i + j)];
    values_[index(i)] = sum / 24;
  }
}

double ShotChoice::best(double present) const {
  double best_score = -1e9, direction = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double turn = wrapAngle(i * kStep - present);
    const double score = values_[index(i)] - kTurnCost * std::fabs(turn);
    if (score > best_score) best_score = score, direction = i * kStep;
  }
  return value(present) >= best_score ? wrapAngle(present) : wrapAngle(direction);
}

double ShotChoice::value(double direction) const {
  const double place = direction / kStep;
  const double below = std::floor(place);
  const int i = static_cast<int>(below);
  const double u = place - below;
  return (1 - u) * values_[index(i)] + u * values_[index(i + 1)];
}

}  // namespace murosimf::controllers
