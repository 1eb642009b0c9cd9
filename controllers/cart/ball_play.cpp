#include "ball_play.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::cart {

namespace {

constexpr double kBehind = 0.3, kNearAhead = 0.24;           // place behind the ball; at which it is at the front [m]
constexpr double kAligned = 0.25, kLost = 0.7;               // [rad] to begin and to give up a push
constexpr double kPush = 0.45, kWalk = 0.5, kFastTurn = 3;   // [m/s, rad/s]
constexpr double kForgets = 3, kSearch = 8, kMostWait = 10;  // [s]
constexpr double kMoved = 0.08;                              // way of the ball that ends the other team's kick-off [m]
constexpr double kLook = 0.45, kSlow = 0.3;                  // free way that is looked for; at which it slows down [m]
constexpr double kKeeperReach = 0.9;                         // of the ball from the keeper's goal [m]

double lengthOf(double x, double y) { return sqrt(x * x + y * y); }

}  // namespace

void BallPlay::describe(const client::RobotDescription& robot, bool omnidirectional) {
  robot_ = robot;
  omnidirectional_ = omnidirectional;
  keeper_ = robot.role == "keeper";
}

std::optional<GroundPoint> BallPlay::ball() const {
  if (!ball_known_) return std::nullopt;
  const SinCos<double> a = sincos(pose_.heading);
  const double dx = ball_x_ - pose_.x, dy = ball_y_ - pose_.y;
  return GroundPoint{a.cos * dx + a.sin * dy, a.cos * dy - a.sin * dx};
}

void BallPlay::see(const client::SensorFrame& sensors, const BaseMotion& way) {
  if (pose_known_) pose_.advance(way);
  if (sensors.own_pose.valid) {
    pose_ = {sensors.own_pose.pose.x, sensors.own_pose.pose.y, sensors.own_pose.pose.heading};
    pose_known_ = true;
  }
  ball_age_ += robot_.control_period;
  seeBall(sensors);
  if (ball_age_ > kForgets) ball_known_ = false;
}

void BallPlay::seeBall(const client::SensorFrame& sensors) {
  for (const client::CameraSights& sight : sensors.sights) {
    if (sight.kind != client::ThingKind::kBall || sight.things.empty() || !pose_known_) continue;
    // The camera sits on the base, which stands upright.
    const Pose& X_BC = robot_.cameras[static_cast<std::size_t>(sight.camera)].X_BC;
    const Vector3 p = X_BC * sight.things.front().p_C;
    const SinCos<double> a = sincos(pose_.heading);
    ball_x_ = pose_.x + a.cos * p.x - a.sin * p.y;
    ball_y_ = pose_.y + a.sin * p.x + a.cos * p.y;
    ball_known_ = true;
    ball_age_ = searched_ = 0;
  }
}

/// At the other team's kick-off.
bool BallPlay::waits(const client::SensorFrame& sensors) {
  if (sensors.game.restart_count != restarts_) {
    restarts_ = sensors.game.restart_count;
    waiting_ = !sensors.game.own_kickoff;
    kickoff_seen_ = pushing_ = false;
    waited_ = 0;
  }
  if (!waiting_) return false;
  waited_ += robot_.control_period;
  if (ball_known_ && !kickoff_seen_) {
    kickoff_x_ = ball_x_, kickoff_y_ = ball_y_;
    kickoff_seen_ = true;
  }
  const bool moved = ball_known_ && kickoff_seen_ && lengthOf(ball_x_ - kickoff_x_, ball_y_ - kickoff_y_) > kMoved;
  waiting_ = !moved && waited_ < kMostWait;
  return waiting_;
}

BaseMotion BallPlay::play(const client::SensorFrame& sensors, LaserGuard& guard) {
  activity_ = "rest";
  if (!pose_known_ || sensors.game.penalised || sensors.game.phase != client::GamePhase::kPlaying) return {};
  if (waits(sensors)) return activity_ = "wait", BaseMotion{};
  guard.forgive(ball(), robot_.field.ball_radius + 0.08);
  if (keeper_ && (!ball_known_ || lengthOf(ball_x_ + 0.5 * robot_.field.length, ball_y_) > kKeeperReach))
    return keep(guard);
  return ball_known_ ? chase(guard) : search(robot_.control_period);
}

BaseMotion BallPlay::chase(LaserGuard& guard) {
  const double goal_x = 0.5 * robot_.field.length + 0.1 - ball_x_, goal_y = -ball_y_;
  const double per = 1 / std::max(lengthOf(goal_x, goal_y), 1e-6), ux = goal_x * per, uy = goal_y * per;
  const double to_goal = atan2(uy, ux);
  const double dx = ball_x_ - pose_.x, dy = ball_y_ - pose_.y, distance = lengthOf(dx, dy);
  const double along = dx * ux + dy * uy, aside = dy * ux - dx * uy;  // of the ball, seen towards the goal
  const bool behind = along > 0 && std::fabs(aside) < 0.5 * along;
  const bool facing = std::fabs(wrapped(to_goal - pose_.heading)) < (pushing_ ? kLost : kAligned);
  pushing_ = behind && facing && (pushing_ ? distance < kBehind + 0.25 : distance < kBehind + 0.06);
  if (pushing_) {
    activity_ = "push";
    return push(to_goal, aside);
  }
  activity_ = "approach";
  Target target{ball_x_ - kBehind * ux, ball_y_ - kBehind * uy, to_goal, kWalk};
  if (along < 0.1 && std::fabs(aside) < kBehind) {  // before the ball: around it, on the side where it is already
    const double side = aside > 0 ? -1 : 1;
    target.x = ball_x_ - side * kBehind * uy - 0.1 * ux;
    target.y = ball_y_ + side * kBehind * ux - 0.1 * uy;
  }
  return goTo(target, guard);
}

/// Straight on, with the ball between the horns.
BaseMotion BallPlay::push(double heading, double aside) const {
  const double off = wrapped(heading - pose_.heading);
  if (omnidirectional_) return {kPush, std::clamp(3 * aside, -0.25, 0.25), 4 * off};
  const GroundPoint seen = *ball();
  const double bearing = atan2(seen.y, std::max(seen.x, kNearAhead));
  return {kPush, 0, std::clamp(3 * bearing + 1.5 * off, -kFastTurn, kFastTurn)};
}

BaseMotion BallPlay::search(double period) {
  activity_ = "search";
  searched_ += period;
  pushing_ = false;
  if (searched_ < kSearch) return {0, 0, 1.2};
  const double x = -0.25 * robot_.field.length - pose_.x, y = -pose_.y;
  if (lengthOf(x, y) < 0.2) searched_ = 0;
  const double bearing = wrapped(atan2(y, x) - pose_.heading);
  return {std::fabs(bearing) < 0.5 ? 0.25 : 0, 0, std::clamp(3 * bearing, -1.5, 1.5)};
}

BaseMotion BallPlay::keep(LaserGuard& guard) {
  activity_ = "keep";
  const double line = -0.5 * robot_.field.length + 0.3, half = 0.5 * robot_.field.goal_width - 0.1;
  const double goal = -0.5 * robot_.field.length;
  const double share = ball_known_ ? 0.3 / std::max(ball_x_ - goal, 0.3) : 0;
  const double y = ball_known_ ? std::clamp(ball_y_ * share, -half, half) : 0;
  const double heading = ball_known_ ? atan2(ball_y_ - pose_.y, ball_x_ - pose_.x) : 0;
  if (lengthOf(line - pose_.x, y - pose_.y) < 0.04)
    return {0, 0, std::clamp(3 * wrapped(heading - pose_.heading), -1.5, 1.5)};
  return goTo({line, y, heading, 0.35}, guard);
}

/// Towards a place, around what the laser sees, and there to a heading.
BaseMotion BallPlay::goTo(const Target& target, LaserGuard& guard) {
  const double dx = target.x - pose_.x, dy = target.y - pose_.y, distance = lengthOf(dx, dy);
  const double off = wrapped(target.heading - pose_.heading);
  const double wanted = wrapped(atan2(dy, dx) - pose_.heading);
  const double look = std::min(distance, kLook);
  const double way = distance > 0.1 ? guard.wayAround(wanted, look) : wanted;
  const double free = guard.freeWay(way, kLook);
  const double speed = std::min({target.speed, 2 * distance, free < look ? target.speed * free / kSlow : target.speed});
  if (omnidirectional_) {
    const SinCos<double> a = sincos(way);
    return {speed * a.cos, speed * a.sin, std::clamp(3 * off, -1.5, 1.5)};
  }
  if (distance < 0.06) return {0, 0, std::clamp(4 * off, -1.8, 1.8)};
  const double turned = wrapped(way);
  const double forward = std::max(cos(turned), 0.0);
  return {speed * forward * forward * forward, 0, std::clamp(4 * turned, -kFastTurn, kFastTurn)};
}

void BallPlay::archive(client::StateArchive& archive) {
  archive(pose_known_, ball_known_, pushing_, waiting_, pose_, ball_x_, ball_y_, ball_age_, searched_);
  archive(kickoff_x_, kickoff_y_, kickoff_seen_, waited_, restarts_);
}

}  // namespace murosimf::controllers::cart
