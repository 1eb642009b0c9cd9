#include "murosimf/soccer/restart_rules.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

constexpr double kOwnHalf = 0.25;     // a robot's base stays this far behind the halfway line [m]
constexpr double kBodyRadius = 0.15;  // room that a robot takes beside the centre circle [m]
constexpr int kRings = 12;

double signOf(double x) { return x < 0 ? -1.0 : 1.0; }

/// The point of the path at which |component| passes the limit; its end when it began beyond.
Vector3 crossing(const Vector3& before, const Vector3& after, double from, double to, double limit) {
  const double a = std::fabs(from), b = std::fabs(to);
  const bool passes = a <= limit && b > limit && from * to > 0;
  return passes ? interpolate(before, after, (limit - a) / (b - a)) : after;
}

bool isFree(const Vector3& place, std::span<const Vector3> robots, double gap) {
  return std::none_of(robots.begin(), robots.end(), [&](const Vector3& robot) {
    const double x = robot.x - place.x, y = robot.y - place.y;
    return x * x + y * y < gap * gap;
  });
}

bool isInside(const client::FieldDescription& field, const Vector3& place) {
  return std::fabs(place.x) <= field.length / 2 - kFieldMargin && std::fabs(place.y) <= field.width / 2 - kFieldMargin;
}

}  // namespace

BallExit judgeExit(const client::FieldDescription& field, const Vector3& before, const Vector3& after) {
  const double outside = field.line_width / 2 + field.ball_radius;
  const double limit_x = field.length / 2 + outside, limit_y = field.width / 2 + outside;
  if (std::fabs(after.x) > limit_x) {
    const Vector3 p = crossing(before, after, before.x, after.x, limit_x);
    if (std::fabs(p.y) <= limit_y) {
      const bool in_goal = std::fabs(p.y) < field.goal_width / 2 && p.z < field.goal_height;
      return {in_goal ? BallExit::Kind::kGoal : BallExit::Kind::kGoalLine, signOf(p.x), p};
    }
  }
  if (std::fabs(after.y) > limit_y) {
    return {BallExit::Kind::kTouchLine, signOf(after.y), crossing(before, after, before.y, after.y, limit_y)};
  }
  return {};
}

Vector3 restartPlace(const client::FieldDescription& field, const BallExit& exit, bool touched_by_defender) {
  const double x = field.length / 2, y = field.width / 2;
  if (exit.kind == BallExit::Kind::kTouchLine) {
    const double farthest = std::max(0.0, x - kCornerInside);
    return {std::clamp(exit.place.x, -farthest, farthest), exit.side * (y - kThrowInInside), 0};
  }
  const double distance = touched_by_defender ? kCornerDistance : kGoalKickDistance;
  return {exit.side * (x - distance), signOf(exit.place.y) * (y - kCornerInside), 0};
}

Vector3 freePlace(const client::FieldDescription& field, const Vector3& place, std::span<const Vector3> robots,
                  double gap) {
  const Vector3 wanted{place.x, place.y, 0};
  if (isFree(wanted, robots, gap)) return wanted;
  constexpr double kHalf = 0.70710678118654752;  // sine of 45 degrees
  // Towards the centre first, then to both sides in turn; from the centre itself along y, which favours no team.
  constexpr double kTurns[8][2] = {{1, 0},  {kHalf, kHalf},  {kHalf, -kHalf},  {0, 1},
                                   {0, -1}, {-kHalf, kHalf}, {-kHalf, -kHalf}, {-1, 0}};
  const double distance = norm(wanted);
  const Vector3 towards = distance > 1e-9 ? wanted * (-1 / distance) : Vector3{0, 1, 0};
  for (int ring = 1; ring <= kRings; ++ring) {
    const double radius = gap / 2 * ring;
    for (const auto& [c, s] : kTurns) {
      const Vector3 p{wanted.x + radius * (c * towards.x - s * towards.y),
                      wanted.y + radius * (s * towards.x + c * towards.y), 0};
      if (isInside(field, p) && isFree(p, robots, gap)) return p;
    }
  }
  return wanted;
}

PlanarPose kickoffPose(const MatchSettings& match, const MatchRobot& robot, Team kickoff_team) {
  const bool kicks = robot.team == kickoff_team;
  const auto& given = kicks ? robot.kickoff_own : robot.kickoff_other;
  if (given) return *given;
  const bool plus = attacksPositiveX(match, robot.team);
  PlanarPose pose = turnedForTeam(robot.start, plus);
  pose.x = std::min(pose.x, -kOwnHalf);
  const double clear = match.field.centre_circle_radius + kBodyRadius;
  if (!kicks && pose.x * pose.x + pose.y * pose.y < clear * clear) pose.x = -sqrt(clear * clear - pose.y * pose.y);
  return turnedForTeam(pose, plus);
}

}  // namespace murosimf
