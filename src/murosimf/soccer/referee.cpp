#include "murosimf/soccer/referee.h"

#include <algorithm>

namespace murosimf {

namespace {

using client::GamePhase;

constexpr double kSetTime = 1.0;  // between placing everybody and the whistle [s]

}  // namespace

Referee::Referee(const MatchSettings& match, Simulation& simulation)
    : match_(match), frame_length_(simulation.frameLength()) {
  if (match.ball.valid()) ball_ = simulation.linked().handle(match.ball, kBasePose);
  for (const MatchRobot& robot : match.robots) {
    paths_.emplace_back(simulation.linked(), robot.object);
    control_indices_.push_back(simulation.control() == nullptr ? -1 : simulation.control()->indexOf(robot.object));
    places_.push_back(robot.start);
  }
  positions_.resize(match.robots.size());
  events_.reserve(256);
  state_.kickoff_team = match.kickoff_team;
  note(MatchEvent::Kind::kKickoff, match.kickoff_team, 0);
  tellRobots(simulation, true);
}

void Referee::afterFrame(Simulation& simulation) {
  if (ball_.valid()) watchBall(simulation);
  if (simulation.frame() % match_.control_period != 0) return;
  const bool placed = decide(simulation);
  checkClock(simulation.frame());
  tellRobots(simulation, placed);
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

bool Referee::decide(Simulation& simulation) {
  const long frame = simulation.frame();
  const double elapsed = seconds(frame - state_.phase_began) + frame_length_ / 2;
  switch (state_.phase) {
    case GamePhase::kReady:
      if (elapsed < match_.pause_after_goal) return false;
      kickOff(simulation);
      return true;
    case GamePhase::kSet:
      if (elapsed < kSetTime) return false;
      begin(GamePhase::kPlaying, frame);
      state_.mark = state_.rest = state_.ball;
      state_.rested_since = frame;
      return false;
    case GamePhase::kPlaying:
      if (ball_.valid()) play(simulation);
      return false;
    case GamePhase::kFinished:
      return false;
  }
  return false;
}

void Referee::play(Simulation& simulation) {
  const long frame = simulation.frame();
  const Vector3 from_mark = state_.ball - state_.mark;
  const bool moved = squaredNorm(from_mark) > match_.ball_moved * match_.ball_moved;
  if (moved || seconds(frame - state_.phase_began) >= match_.kickoff_wait) state_.kicked_off = true;
  if (state_.exit.kind == BallExit::Kind::kGoal) {
    countGoal();
    begin(GamePhase::kReady, frame);
  } else if (state_.exit.kind != BallExit::Kind::kNone) {
    putBack(simulation);
  } else if (isStuck(frame)) {
    note(MatchEvent::Kind::kStuck, state_.last, simulation.time());
    putBall(simulation, {}, kDropGap);
  }
}

void Referee::countGoal() {
  const bool red_scores = (state_.exit.side > 0) == match_.red_attacks_positive_x;
  const Team team = red_scores ? Team::kRed : Team::kBlue;
  ++state_.score[teamIndex(team)];
  state_.kickoff_team = otherTeam(team);
  note(MatchEvent::Kind::kGoal, team, state_.exit_time);
}

void Referee::putBack(Simulation& simulation) {
  const bool over_touch_line = state_.exit.kind == BallExit::Kind::kTouchLine;
  note(over_touch_line ? MatchEvent::Kind::kTouchLine : MatchEvent::Kind::kGoalLine, state_.last, state_.exit_time);
  const bool attackers_goal = (state_.exit.side > 0) == attacksPositiveX(match_, state_.last);
  const bool by_defender = state_.touched && !attackers_goal;
  putBall(simulation, restartPlace(match_.field, state_.exit, by_defender), kRestartGap);
}

bool Referee::isStuck(long frame) {
  const Vector3 moved = state_.ball - state_.rest;
  if (moved.x * moved.x + moved.y * moved.y > kStuckDistance * kStuckDistance) {
    state_.rest = state_.ball;
    state_.rested_since = frame;
  }
  return seconds(frame - state_.rested_since) >= kStuckTime;
}

void Referee::checkClock(long frame) {
  if (state_.phase == GamePhase::kFinished) return;
  if (seconds(frame - state_.half_began) + frame_length_ / 2 < halfLength()) return;
  if (match_.half_length > 0 && !state_.second_half) {
    state_.second_half = true;
    state_.half_began = frame;
    state_.kickoff_team = otherTeam(match_.kickoff_team);
    note(MatchEvent::Kind::kHalfTime, state_.kickoff_team, seconds(frame));
    begin(GamePhase::kReady, frame);
    return;
  }
  note(MatchEvent::Kind::kFinish, state_.last, seconds(frame));
  begin(GamePhase::kFinished, frame);
}

void Referee::kickOff(Simulation& simulation) {
  for (std::size_t i = 0; i < match_.robots.size(); ++i) {
    places_[i] = kickoffPose(match_, match_.robots[i], state_.kickoff_team);
    simulation.interventions().placeRobot(simulation.frame(), match_.robots[i].object, places_[i]);
  }
  if (ball_.valid()) {
    for (std::size_t i = 0; i < places_.size(); ++i) positions_[i] = {places_[i].x, places_[i].y, 0};
    const Vector3 centre = freePlace(match_.field, {}, positions_, kKickoffGap);
    simulation.interventions().placeBody(simulation.frame(), match_.ball,
                                         {centre.x, centre.y, match_.field.ball_radius});
    state_.ball = {centre.x, centre.y, match_.field.ball_radius};
  }
  state_.kicked_off = state_.touched = false;
  ++state_.restarts;
  note(MatchEvent::Kind::kKickoff, state_.kickoff_team, simulation.time());
  begin(GamePhase::kSet, simulation.frame());
}

void Referee::begin(GamePhase phase, long frame) {
  state_.phase = phase;
  state_.phase_began = frame;
  state_.exit = {};
}

void Referee::putBall(Simulation& simulation, const Vector3& place, double gap) {
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    positions_[i] = paths_[i].position(0, paths_[i].shareAfter(simulation.frame() - 1));
  }
  const Vector3 p = freePlace(match_.field, place, positions_, gap);
  state_.ball = state_.rest = {p.x, p.y, match_.field.ball_radius};
  state_.rested_since = simulation.frame();
  state_.exit = {};
  ++state_.restarts;
  simulation.interventions().placeBody(simulation.frame(), match_.ball, state_.ball);
}

void Referee::tellRobots(Simulation& simulation, bool placed) const {
  if (simulation.control() == nullptr) return;
  const double left = std::max(0.0, halfLength() - seconds(simulation.frame() - state_.half_began));
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
    game.placed = placed;
    game.placed_at = turnedForTeam(places_[i], attacksPositiveX(match_, team));
    simulation.control()->setGame(control_indices_[i], game);
  }
}

void Referee::note(MatchEvent::Kind kind, Team team, double time) {
  const Vector3 place = state_.exit.kind == BallExit::Kind::kNone ? state_.ball : state_.exit.place;
  events_.push_back({kind, team, time, place});
}

void Referee::archive(StateArchive& archive) { archive(state_, places_, events_); }

}  // namespace murosimf
