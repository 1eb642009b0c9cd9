#include "murosimf/soccer/referee.h"

#include <cmath>

#include "murosimf/soccer/course_referee.h"
#include "murosimf/soccer/match_referee.h"
#include "murosimf/soccer/penalty_referee.h"

namespace murosimf {

using client::GamePhase;

Referee::Referee(const MatchSettings& match, Simulation& simulation)
    : match_(match), frame_length_(simulation.frameLength()) {
  if (match.ball.valid()) {
    ball_ = simulation.linked().handle(match.ball, kBasePose);
    ball_velocity_ = simulation.linked().handle(match.ball, kBodyVelocity);
  }
  for (const MatchRobot& robot : match.robots) {
    paths_.emplace_back(simulation.linked(), robot.object);
    control_indices_.push_back(simulation.control() == nullptr ? -1 : simulation.control()->indexOf(robot.object));
    places_.push_back(robot.start);
    beamed_.push_back(0);
  }
  events_.reserve(256);
  state_.kickoff_team = match.kickoff_team;
}

void Referee::afterFrame(Simulation& simulation) {
  if (ball_.valid()) watchBall(simulation);
  if (simulation.frame() % match_.control_period != 0) return;
  obeyBeams(simulation);
  const bool placed = decide(simulation);
  tellRobots(simulation, placed);
}

void Referee::obeyBeams(Simulation& simulation) {
  beamed_.assign(match_.robots.size(), 0);
  if (simulation.control() == nullptr) return;
  const bool free = state_.phase == GamePhase::kSet || state_.phase == GamePhase::kReady;
  const double longest = match_.field.length / 2 + match_.field.border;
  const double widest = match_.field.width / 2 + match_.field.border;
  for (std::size_t i = 0; i < match_.robots.size(); ++i) {
    if (control_indices_[i] < 0) continue;
    const std::optional<PlanarPose> beam = simulation.control()->takeBeam(control_indices_[i]);
    const bool allowed =
        beam && std::isfinite(beam->heading) && beam->x <= 0 && beam->x >= -longest && std::abs(beam->y) <= widest;
    if (!free || !allowed) continue;
    putRobot(simulation, i, turnedForTeam(*beam, attacksPositiveX(match_, match_.robots[i].team)));
    beamed_[i] = 1;
  }
}

void Referee::watchBall(Simulation& simulation) {
  const Vector3 before = state_.ball;
  state_.ball = ball_.get().translation;
  for (const PairPhase::Touch& touch : simulation.pairs().touches()) {
    if (touch.body != match_.ball || !touch.partner.valid()) continue;
    for (const MatchRobot& robot : match_.robots) {
      if (robot.object == touch.partner) state_.touched = true, state_.last = robot.team;
    }
  }
  if (state_.phase != GamePhase::kPlaying || state_.exit.kind != BallExit::Kind::kNone) return;
  state_.exit = judgeExit(match_.field, before, state_.ball);
  state_.exit_time = simulation.time();
}

void Referee::begin(GamePhase phase, long frame) {
  state_.phase = phase;
  state_.phase_began = frame;
  state_.exit = {};
}

void Referee::whistle(long frame) {
  begin(GamePhase::kPlaying, frame);
  state_.mark = state_.ball;
}

void Referee::checkKickedOff(long frame) {
  const Vector3 from_mark = state_.ball - state_.mark;
  const bool moved = squaredNorm(from_mark) > match_.ball_moved * match_.ball_moved;
  if (moved || seconds(frame - state_.phase_began) >= match_.kickoff_wait) state_.kicked_off = true;
}

void Referee::putRobot(Simulation& simulation, std::size_t robot, const PlanarPose& place, const PlanarPose& error) {
  places_[robot] = place;
  const Vector3 p_WB = toPose(place) * Vector3{error.x, error.y, 0};
  simulation.interventions().placeRobot(simulation.frame(), match_.robots[robot].object,
                                        {p_WB.x, p_WB.y, wrapAngle(place.heading + error.heading)});
}

void Referee::putBall(Simulation& simulation, const Vector3& place) {
  state_.ball = {place.x, place.y, match_.field.ball_radius};
  state_.exit = {};
  simulation.interventions().placeBody(simulation.frame(), match_.ball, state_.ball);
}

Vector3 Referee::position(std::size_t robot, const Simulation& simulation) const {
  return paths_[robot].position(0, paths_[robot].shareAfter(simulation.frame() - 1));
}

void Referee::tellRobots(Simulation& simulation, bool placed) const {
  if (simulation.control() == nullptr) return;
  const double left = timeLeft(simulation.frame());
  for (std::size_t i = 0; i < match_.robots.size(); ++i) {
    if (control_indices_[i] < 0) continue;
    const Team team = match_.robots[i].team;
    client::GameInfo game;
    game.phase = state_.phase;
    game.own_kickoff = team == state_.kickoff_team;
    game.time_left = left;
    game.own_score = score(team);
    game.opponent_score = score(otherTeam(team));
    game.restart_count = state_.restarts;
    game.placed = placed || beamed_[i] != 0;
    game.placed_at = turnedForTeam(places_[i], attacksPositiveX(match_, team));
    simulation.control()->setGame(control_indices_[i], game);
  }
}

void Referee::note(MatchEvent::Kind kind, Team team, double time) {
  const Vector3 place = state_.exit.kind == BallExit::Kind::kNone ? state_.ball : state_.exit.place;
  events_.push_back({kind, team, time, place});
}

std::string Referee::scoreText() const {
  return "red " + std::to_string(score(Team::kRed)) + " : " + std::to_string(score(Team::kBlue)) + " blue";
}

void Referee::archive(StateArchive& archive) { archive(state_, places_, events_); }

std::unique_ptr<Referee> makeReferee(const MatchSettings& match, Simulation& simulation) {
  switch (match.rules) {
    case Rules::kMatch:
      return std::make_unique<MatchReferee>(match, simulation);
    case Rules::kPenaltyKicks:
      return std::make_unique<PenaltyReferee>(match, simulation);
    case Rules::kSlalom:
    case Rules::kObstacleRun:
      return std::make_unique<CourseReferee>(match, simulation);
  }
  return nullptr;
}

}  // namespace murosimf
