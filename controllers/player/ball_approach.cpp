#include "ball_approach.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

namespace {

constexpr KickZone kZone;
constexpr double kBehind = 0.12;                      // standoff behind the kick pose [m]
constexpr double kBallCircle = 0.26;                  // the hips keep this far from the ball when going around [m]
constexpr double kObstacleClearance = 0.32;           // [m]
constexpr WalkCommand kLineUpSpeed{0.12, 0.08, 0.8};  // largest
constexpr double kRollingDeceleration = 0.3;          // [m/s^2]
constexpr double kReach = 0.6;                        // "near the ball" [m]
constexpr double kRetreatTime = 4.0;                  // [s]

/// Where the rolling ball will be when the robot gets there, at the latest where it stops.
Point meetingPoint(const Situation& now) {
  const double speed = norm(now.ball_velocity_R);
  if (speed < 0.1) return now.ball_R;
  const double time = std::min(speed / kRollingDeceleration, norm(now.ball_R) / 0.2);
  const double way = std::min(1.5, speed * time - 0.5 * kRollingDeceleration * time * time);
  return now.ball_R + (way / speed) * now.ball_velocity_R;
}

/// Pose in which the robot would come to rest if it stopped now, in R: it slows down evenly.
PlanarPose restingPose(const WalkCommand& v) {
  const WalkCommand& change = WalkParameters{}.largest_change;
  return {v.vx * std::fabs(v.vx) / (2 * change.vx), v.vy * std::fabs(v.vy) / (2 * change.vy),
          v.omega * std::fabs(v.omega) / (2 * change.omega)};
}

}  // namespace

void BallApproach::restart() { *this = BallApproach{}; }

void BallApproach::giveWay() { retreat_left_ = kRetreatTime; }

void BallApproach::chooseDirection(const Situation& now, const Pitch& pitch) {
  std::array<Point, 12> robots_F;
  const std::size_t count = std::min(now.robots_R.size(), robots_F.size());
  for (std::size_t i = 0; i < count; ++i) robots_F[i] = transformed(now.X_FR, now.robots_R[i]);
  const Point ball_R = meetingPoint(now);
  shot_.evaluate(pitch, transformed(now.X_FR, ball_R), {robots_F.data(), count});
  // Near the ball the heading is what a kick would follow, far from it the way there.
  const double present_R = norm(ball_R) < 0.35 ? 0.0 : direction(ball_R);
  const double best_F = shot_.best(wrapAngle(now.X_FR.heading + present_R));
  best_value_ = shot_.value(best_F);
  direction_R_ = wrapAngle(best_F - now.X_FR.heading);
}

void BallApproach::chooseFoot(const Point& ball_R) {
  const int nearer = ball_R.y >= 0 ? kLeft : kRight;
  const bool clear = std::fabs(ball_R.y) > 0.03;  // does not change its mind for a ball straight ahead
  if (!foot_chosen_ || clear) foot_ = nearer, foot_chosen_ = true;
}

PlanarPose BallApproach::kickPose(const Point& ball_R, double back) const {
  const double s = sideSign(foot_);
  const double heading = wrapAngle(direction_R_ - s * kKickDeviation);
  const Point p = ball_R - turned(sincos(heading), {kZone.x + back, s * kZone.y});
  return {p.x, p.y, heading};
}

bool BallApproach::ballInZone(const Point& ball_R, double margin_x, double margin_y) const {
  const double y = ball_R.y * sideSign(foot_);
  return ball_R.x > kZone.lowest_x - margin_x && ball_R.x < kZone.highest_x + margin_x &&
         y > kZone.lowest_y - margin_y && y < kZone.highest_y + margin_y;
}

bool BallApproach::worthKicking(const Situation& now) const {
  const double kicked_F = now.X_FR.heading + restingPose(now.velocity).heading + sideSign(foot_) * kKickDeviation;
  const double patience = 0.25 + 0.06 * std::max(0.0, time_near_ - 6);  // gives in, but never to an own goal
  return shot_.value(kicked_F) > std::max(best_value_ - patience, -6.0);
}

Decision BallApproach::step(const Situation& now, const Pitch& pitch) {
  time_near_ = norm(now.ball_R) < kReach ? time_near_ + now.dt : 0.0;
  chooseDirection(now, pitch);
  if (stage_ != Stage::kStop) chooseFoot(now.ball_R);
  if (stage_ != Stage::kStop && gaveUp(now)) return stepAside(now);
  switch (stage_) {
    case Stage::kGoBehind:
      return goBehind(now);
    case Stage::kLineUp:
      return lineUp(now);
    case Stage::kStop:
      return stopAndKick(now);
  }
  return {};
}

/// Two robots that block each other at the ball would stand there for ever: after a while the one that looks the wrong
/// way steps aside, later the other, and of two alike the one with the higher number.
bool BallApproach::gaveUp(const Situation& now) {
  const bool well_placed = std::fabs(direction_R_) < degrees(60);
  const double patience = (well_placed ? 13.0 : 8.0) - 0.7 * now.number;
  if (retreat_left_ <= 0 && time_near_ > patience) retreat_left_ = kRetreatTime, stage_ = Stage::kGoBehind;
  if (retreat_left_ <= 0) return false;
  retreat_left_ -= now.dt;
  if (retreat_left_ <= 0) time_near_ = 0;
  return true;
}

/// Out of the line of the opponent's kick, facing the ball.
Decision BallApproach::stepAside(const Situation& now) const {
  const double away = now.ball_R.y > 0 ? -1 : 1;
  const WalkCommand walk{-0.04, 0.08 * away, clamp(direction(now.ball_R), -0.4, 0.4)};
  return {{MotionRequest::Kind::kWalk, walk, kRight}, HeadRequest::Kind::kBallAndField, "give way"};
}

Decision BallApproach::goBehind(const Situation& now) {
  const Point ball_R = meetingPoint(now);
  const PlanarPose goal = kickPose(ball_R, kBehind);
  const PlanarPose kick = kickPose(now.ball_R, 0);
  // Where the robot is, seen from the kick pose: behind it, not beside it, looking along.
  const Point from_kick = turnedBack(sincos(kick.heading), Point{-kick.x, -kick.y});
  const bool behind = from_kick.x > -0.32 && from_kick.x < 0.05 && std::fabs(from_kick.y) < 0.08;
  if (behind && std::fabs(kick.heading) < degrees(25)) {
    stage_ = Stage::kLineUp;
    return lineUp(now);
  }
  Point way = wayAround(ball_R, kBallCircle, {goal.x, goal.y});
  const bool direct = way.x == goal.x && way.y == goal.y;
  way = detour(way, now.obstacles_R, kObstacleClearance, 0.35);
  // On the way round the robot keeps its eyes on the ball unless it has far to go.
  const double heading = direct ? goal.heading : direction(ball_R);
  return {{MotionRequest::Kind::kWalk, walkTo({way.x, way.y, heading}), kRight},
          norm(now.ball_R) > 0.5 ? HeadRequest::Kind::kBallAndField : HeadRequest::Kind::kWatchBall,
          "approach"};
}

Decision BallApproach::lineUp(const Situation& now) {
  const PlanarPose kick = kickPose(now.ball_R, 0);
  const Point from_kick = turnedBack(sincos(kick.heading), Point{-kick.x, -kick.y});
  const bool lost = from_kick.x < -0.42 || std::fabs(from_kick.y) > 0.15 || std::fabs(kick.heading) > degrees(40) ||
                    now.ball_R.x < 0.08;
  if (lost) stage_ = Stage::kGoBehind;
  const bool ready = ballInZone(transformedBack(restingPose(now.velocity), now.ball_R), -0.015, -0.005) &&
                     worthKicking(now) && norm(now.ball_velocity_R) < 0.15;
  if (ready) stage_ = Stage::kStop;
  const WalkCommand walk{clamp(1.5 * kick.x, -kLineUpSpeed.vx, kLineUpSpeed.vx),
                         clamp(2.0 * kick.y, -kLineUpSpeed.vy, kLineUpSpeed.vy),
                         clamp(2.0 * kick.heading, -kLineUpSpeed.omega, kLineUpSpeed.omega)};
  return {{MotionRequest::Kind::kWalk, walk, kRight}, HeadRequest::Kind::kWatchBall, "line up"};
}

Decision BallApproach::stopAndKick(const Situation& now) {
  Decision decision{{MotionRequest::Kind::kStand, {}, foot_}, HeadRequest::Kind::kWatchBall, "kick"};
  if (!ballInZone(transformedBack(restingPose(now.velocity), now.ball_R), 0, 0.01)) {
    stage_ = Stage::kLineUp;
    return decision;
  }
  if (now.settled && now.ball_age < 0.4) decision.motion.kind = MotionRequest::Kind::kKick;
  return decision;
}

double BallApproach::cost(const Situation& now, const Pitch& pitch) {
  const Point ball_R = meetingPoint(now);
  const Point goal_R = transformedBack(now.X_FR, pitch.attackedGoal());
  const double bearing = direction(ball_R);
  const double around = std::fabs(wrapAngle(direction(goal_R - ball_R) - bearing));  // has to walk round the ball
  return norm(ball_R) / 0.2 + std::fabs(bearing) / 0.8 + 1.0 * around + now.ball_age;
}

void BallApproach::archive(client::StateArchive& archive) {
  archive(stage_, foot_, foot_chosen_, direction_R_, best_value_, time_near_, retreat_left_);
}

}  // namespace murosimf::controllers
