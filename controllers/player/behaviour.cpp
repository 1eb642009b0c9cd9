#include "behaviour.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

namespace {

constexpr double kLongestWait = 10.0;   // for the opponents' kick-off [s]
constexpr double kMovedDistance = 0.2;  // a ball this far from where it lay has been kicked off [m]
constexpr double kSweepTime = 1.5, kTurnTime = 11.0, kTurnRate = 0.65;  // search [s], [s], [rad/s]
constexpr double kStepBackTime = 4.0;                                   // [s]
constexpr double kStayBonus = 1.0;  // who is on the way to the ball keeps going unless a mate is this much faster [s]
constexpr double kHeadStart = 0.25, kLongestBlock = 6.0;  // [m], [s]
constexpr double kBlockedKick = 0.25;  // a kicked ball that has not moved this far met somebody's feet [m]
constexpr double kNoCost = 1e9;
constexpr Point kWatchedWay{1.1, 0};    // where a runner looks, in R [m]
constexpr double kLostDeviation = 0.5;  // of the own position: time to look for landmarks [m]

double clampAge(double age) { return std::min(age, 5.0); }

}  // namespace

void Behaviour::start(const client::RobotDescription& robot) {
  pitch_ = Pitch::of(robot.field);
  course_.start(robot);
}

void Behaviour::restart() {
  course_.restart();
  dropPlay();
}

void Behaviour::dropPlay() {
  approach_.restart();
  attacks_ = at_place_ = last_near_ = false;
  searched_ = 0;
}

void Behaviour::updateKickoff(const Situation& now) {
  const bool begins = now.game.phase == client::GamePhase::kPlaying && phase_ != client::GamePhase::kPlaying;
  phase_ = now.game.phase;
  if (begins) waits_ = !now.game.own_kickoff, waited_ = 0, waits_saw_ball_ = false;
  if (!waits_) return;
  waited_ += now.dt;
  if (now.ball_known && !waits_saw_ball_) waits_ball_R_ = now.ball_R, waits_saw_ball_ = true;  // the robot stands still
  const bool moved = waits_saw_ball_ && now.ball_known && norm(now.ball_R - waits_ball_R_) > kMovedDistance;
  if (moved || waited_ > kLongestWait) waits_ = false;
}

Behaviour::BallPlace Behaviour::ballPlace(const Situation& now) {
  if (now.ball_known) return {true, now.ball_F()};
  return {now.team_ball_known, now.team_ball_F};
}

double Behaviour::ownCost(const Situation& now, const BallPlace& ball) const {
  if (!ball.known) return kNoCost;
  const bool leaves_it = now.role == Role::kKeeper && !inKeeperZone(pitch_, ball.p_F, attacks_ ? 0.3 : 0.0);
  if (leaves_it) return kNoCost;
  Situation seen = now;
  if (!now.ball_known) seen.ball_R = transformedBack(now.X_FR, ball.p_F), seen.ball_age = 2, seen.ball_velocity_R = {};
  seen.ball_age = clampAge(seen.ball_age);
  return BallApproach::cost(seen, pitch_);
}

bool Behaviour::goesToBall(const Situation& now, const BallPlace& ball) {
  cost_ = ownCost(now, ball);
  if (cost_ >= kNoCost) return false;
  if (attacks_) cost_ = std::max(0.0, cost_ - kStayBonus);
  return cheapestToBall(now.number, cost_, now.mates);
}

Play Behaviour::step(const Situation& now, bool head_glances) {
  updateKickoff(now);
  const BallPlace ball = ballPlace(now);
  if (now.ball_known && std::fabs(now.ball_R.y) > 0.1) last_side_ = now.ball_R.y > 0 ? 1 : -1;
  if (now.ball_known) last_near_ = norm(now.ball_R) < 0.3;
  searched_ = ball.known ? 0.0 : searched_ + now.dt;
  cost_ = kNoCost;
  const Decision decision = decide(now, ball);
  Situation watched = now;
  if (runs(now)) watched.ball_known = true, watched.ball_R = kWatchedWay;
  return {decision.motion, headRequest(watched, decision.head, head_glances), cost_, decision.activity};
}

Decision Behaviour::decide(const Situation& now, const BallPlace& ball) {
  const HeadRequest::Kind look =
      now.ball_known || runs(now) ? HeadRequest::Kind::kBallAndField : HeadRequest::Kind::kSearch;
  if (now.fallen) {
    course_.fall();
    dropPlay();
    kicked_ = false;  // a kick that ended in a fall tells nothing
    return {{}, HeadRequest::Kind::kAhead, "get up"};
  }
  if (now.game.phase != client::GamePhase::kPlaying || now.game.penalised) {
    dropPlay();
    return {{}, look, "stand"};
  }
  if (runs(now)) return course_.step(now);
  if (waits_) return {{}, look, "wait for kick-off"};
  judgeKick(now);
  if (now.kicking) {
    approach_.restart();
    const bool ball_away = now.kick_time > kKickContactTime;
    cost_ = ball_away ? ownCost(now, ball) + kKickTime - now.kick_time : 0.0;
    return {{}, now.ball_known ? HeadRequest::Kind::kWatchBall : HeadRequest::Kind::kSearch, "kick"};
  }
  return ball.known ? play(now, ball) : search(now);
}

Decision Behaviour::search(const Situation& now) {
  attacks_ = false;
  approach_.restart();
  const bool looks_first = searched_ < kSweepTime || now.role == Role::kKeeper;
  const bool turns = searched_ < kSweepTime + kTurnTime && now.role != Role::kKeeper;
  if (looks_first || turns) {
    Decision decision{{}, HeadRequest::Kind::kSearch, "search"};
    if (looks_first && now.role == Role::kKeeper && searched_ > kSweepTime) {
      decision = keepPlace(now, homePlace(pitch_, now.role, now.wing), {0, 0}, "search");
    } else if (last_near_ && now.role != Role::kKeeper && searched_ < kStepBackTime) {
      decision.motion = {MotionRequest::Kind::kWalk, {-0.08, 0, 0}, kRight};  // it lies between the feet
    } else if (!looks_first) {
      decision.motion = {MotionRequest::Kind::kWalk, {0, 0, last_side_ * kTurnRate}, kRight};
    }
    decision.head = HeadRequest::Kind::kSearch;
    return decision;
  }
  Decision decision = keepPlace(now, homePlace(pitch_, now.role, now.wing), {0, 0}, "search");
  if (at_place_) searched_ = 0;  // turns once more from there
  decision.head = HeadRequest::Kind::kSearch;
  return decision;
}

Decision Behaviour::play(const Situation& now, const BallPlace& ball) {
  attacks_ = goesToBall(now, ball);
  if (attacks_) {
    if (leavesBallToOpponent(now)) return keepPlace(now, blockPlace(pitch_, ball.p_F), ball.p_F, "block");
    at_place_ = false;
    return attack(now, ball);
  }
  approach_.restart();
  if (now.role == Role::kKeeper) return keepPlace(now, keeperPlace(pitch_, ball.p_F), ball.p_F, "keep");
  const Point own{now.X_FR.x, now.X_FR.y};
  return keepPlace(now, supportPlace(pitch_, now.role, ball.p_F, own, now.wing), ball.p_F, "support");
}

/// A ball that stays where it was has been kicked against somebody's feet. Whoever has less to lose steps back first,
/// or both would go on kicking each other's feet.
void Behaviour::judgeKick(const Situation& now) {
  if (now.kicking && !kicked_) kick_place_F_ = now.ball_F();
  const bool over = kicked_ && !now.kicking;
  kicked_ = now.kicking;
  if (!over || !now.ball_known) return;
  blocked_kicks_ = norm(now.ball_F() - kick_place_F_) < kBlockedKick ? blocked_kicks_ + 1 : 0;
  if (blocked_kicks_ < 4 - now.number) return;
  blocked_kicks_ = 0;
  approach_.giveWay();
}

/// An opponent who is at the ball first will kick it. Running into him makes a knot of feet out of which no ball comes;
/// standing in his way at some distance stops the kick or turns it aside. After a while somebody must go, though.
bool Behaviour::leavesBallToOpponent(const Situation& now) {
  bool there = false;
  const double own = norm(now.ball_R);
  for (const Point& robot_R : now.robots_R) {
    const bool mate = std::any_of(now.mates.begin(), now.mates.end(), [&](const client::TeamMessage& m) {
      return norm(transformedBack(now.X_FR, {m.pose.x, m.pose.y}) - robot_R) < 0.35;
    });
    const double gap = norm(robot_R - now.ball_R);
    const bool behind_ball = transformed(now.X_FR, robot_R).x > now.ball_F().x;  // he need not walk round it
    there = there || (!mate && behind_ball && gap < 0.4 && gap + kHeadStart < own);
  }
  left_for_ = there && now.ball_known && norm(now.ball_velocity_R) < 0.2 ? left_for_ + now.dt : 0.0;
  return there && now.ball_known && left_for_ < kLongestBlock;
}

Decision Behaviour::attack(const Situation& now, const BallPlace& ball) {
  if (now.ball_known) return approach_.step(now, pitch_);
  // A mate sees it: go there and look for it on the way.
  const Point ball_R = transformedBack(now.X_FR, ball.p_F);
  const Point way = detour(ball_R, now.obstacles_R, 0.32, 0.35);
  WalkCommand walk = walkTo({way.x, way.y, direction(ball_R)});
  if (norm(ball_R) < 0.6) walk = turnTo(direction(ball_R)), walk.vx = -0.06;  // perhaps it lies between the feet
  return {{MotionRequest::Kind::kWalk, walk, kRight}, HeadRequest::Kind::kSearch, "go to told ball"};
}

Decision Behaviour::keepPlace(const Situation& now, const Point& place_F, const Point& facing_F, const char* activity) {
  const Point place_R = transformedBack(now.X_FR, place_F), facing_R = transformedBack(now.X_FR, facing_F);
  const double distance = norm(place_R), bearing = direction(facing_R);
  const bool keeper = now.role == Role::kKeeper;
  const double leave = keeper ? 0.10 : 0.30, arrive = keeper ? 0.04 : 0.12;
  at_place_ = at_place_ ? distance < leave && std::fabs(bearing) < degrees(35)
                        : distance < arrive && std::fabs(bearing) < degrees(12);
  Decision decision{{}, now.ball_known ? HeadRequest::Kind::kBallAndField : HeadRequest::Kind::kSearch, activity};
  if (at_place_) return decision;
  const Point way = detour(place_R, now.obstacles_R, 0.32, 0.0);
  decision.motion = {MotionRequest::Kind::kWalk, walkTo({way.x, way.y, bearing}, 0.2), kRight};
  return decision;
}

Vector3 Behaviour::landmark(const Situation& now) const {
  const std::array<Point, 4> places{pitch_.attackedGoal(), Point{0, pitch_.half_width}, pitch_.ownGoal(),
                                    Point{0, -pitch_.half_width}};
  const Point p_R = transformedBack(now.X_FR, places[static_cast<std::size_t>(landmark_)]);
  return {p_R.x, p_R.y, 0.25};
}

HeadRequest Behaviour::headRequest(const Situation& now, HeadRequest::Kind kind, bool head_glances) {
  const bool lost = kind == HeadRequest::Kind::kBallAndField && now.position_deviation > kLostDeviation;
  if (lost) kind = HeadRequest::Kind::kLookAround;
  HeadRequest request{kind, {now.ball_R.x, now.ball_R.y, pitch_.ball_radius}, {}, false};
  if (!head_glances) landmark_ = static_cast<int>(std::floor(now.time / 2.3)) % 4;
  for (int tried = 0; tried < 4 && !request.has_landmark; ++tried) {
    request.landmark = landmark(now);
    const Point p{request.landmark.x, request.landmark.y};
    request.has_landmark = head_glances || (norm(p) > 0.7 && std::fabs(direction(p)) < degrees(80));
    if (!request.has_landmark) landmark_ = (landmark_ + 1) % 4;
  }
  return request;
}

void Behaviour::archive(client::StateArchive& archive) {
  archive(approach_, course_, phase_, waits_, waited_, waits_saw_ball_, waits_ball_R_, attacks_, at_place_, searched_,
          last_side_, left_for_, kicked_, kick_place_F_, blocked_kicks_, last_near_, landmark_, cost_);
}

}  // namespace murosimf::controllers
