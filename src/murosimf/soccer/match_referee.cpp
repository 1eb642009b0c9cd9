#include "murosimf/soccer/match_referee.h"

#include <algorithm>

namespace murosimf {

using client::GamePhase;

MatchReferee::MatchReferee(const MatchSettings& match, Simulation& simulation) : Referee(match, simulation) {
  positions_.resize(match.robots.size());
  note(MatchEvent::Kind::kKickoff, match.kickoff_team, 0);
  tellRobots(simulation, true);
}

bool MatchReferee::decide(Simulation& simulation) {
  const bool placed = decideOnPhase(simulation);
  checkClock(simulation.frame());
  return placed;
}

bool MatchReferee::decideOnPhase(Simulation& simulation) {
  const long frame = simulation.frame();
  switch (state_.phase) {
    case GamePhase::kReady:
      if (elapsed(frame) < match_.pause_after_goal) return false;
      kickOff(simulation);
      return true;
    case GamePhase::kSet:
      if (elapsed(frame) < kSetTime) return false;
      whistle(frame);
      halves_.rest = state_.ball;
      halves_.rested_since = frame;
      return false;
    case GamePhase::kPlaying:
      if (hasBall()) play(simulation);
      return false;
    case GamePhase::kFinished:
      return false;
  }
  return false;
}

void MatchReferee::play(Simulation& simulation) {
  const long frame = simulation.frame();
  checkKickedOff(frame);
  if (state_.exit.kind == BallExit::Kind::kGoal) {
    countGoal();
    begin(GamePhase::kReady, frame);
  } else if (state_.exit.kind != BallExit::Kind::kNone) {
    putBack(simulation);
  } else if (isStuck(frame)) {
    note(MatchEvent::Kind::kStuck, state_.last, simulation.time());
    dropBall(simulation, {}, kDropGap);
  }
}

void MatchReferee::countGoal() {
  const bool red_scores = (state_.exit.side > 0) == match_.red_attacks_positive_x;
  const Team team = red_scores ? Team::kRed : Team::kBlue;
  ++state_.score[teamIndex(team)];
  state_.kickoff_team = otherTeam(team);
  note(MatchEvent::Kind::kGoal, team, state_.exit_time);
}

void MatchReferee::putBack(Simulation& simulation) {
  const bool over_touch_line = state_.exit.kind == BallExit::Kind::kTouchLine;
  note(over_touch_line ? MatchEvent::Kind::kTouchLine : MatchEvent::Kind::kGoalLine, state_.last, state_.exit_time);
  const bool attackers_goal = (state_.exit.side > 0) == attacksPositiveX(match_, state_.last);
  const bool by_defender = state_.touched && !attackers_goal;
  dropBall(simulation, restartPlace(match_.field, state_.exit, by_defender), kRestartGap);
}

bool MatchReferee::isStuck(long frame) {
  const Vector3 moved = state_.ball - halves_.rest;
  if (moved.x * moved.x + moved.y * moved.y > kStuckDistance * kStuckDistance) {
    halves_.rest = state_.ball;
    halves_.rested_since = frame;
  }
  return seconds(frame - halves_.rested_since) >= kStuckTime;
}

void MatchReferee::checkClock(long frame) {
  if (state_.phase == GamePhase::kFinished) return;
  if (timeLeft(frame) > seconds(1) / 2) return;
  if (match_.half_length > 0 && !halves_.second) {
    halves_.second = true;
    halves_.half_began = frame;
    state_.kickoff_team = otherTeam(match_.kickoff_team);
    note(MatchEvent::Kind::kHalfTime, state_.kickoff_team, seconds(frame));
    begin(GamePhase::kReady, frame);
    return;
  }
  note(MatchEvent::Kind::kFinish, state_.last, seconds(frame));
  begin(GamePhase::kFinished, frame);
}

double MatchReferee::timeLeft(long frame) const {
  return std::max(0.0, halfLength() - seconds(frame - halves_.half_began));
}

void MatchReferee::kickOff(Simulation& simulation) {
  for (std::size_t i = 0; i < match_.robots.size(); ++i) {
    const PlanarPose place = kickoffPose(match_, match_.robots[i], state_.kickoff_team);
    putRobot(simulation, i, place);
    positions_[i] = {place.x, place.y, 0};
  }
  if (hasBall()) putBall(simulation, freePlace(match_.field, {}, positions_, kKickoffGap));
  state_.kicked_off = state_.touched = false;
  ++state_.restarts;
  note(MatchEvent::Kind::kKickoff, state_.kickoff_team, simulation.time());
  begin(GamePhase::kSet, simulation.frame());
}

/// Near the place, where no robot stands.
void MatchReferee::dropBall(Simulation& simulation, const Vector3& place, double gap) {
  for (std::size_t i = 0; i < positions_.size(); ++i) positions_[i] = position(i, simulation);
  putBall(simulation, freePlace(match_.field, place, positions_, gap));
  halves_.rest = state_.ball;
  halves_.rested_since = simulation.frame();
  ++state_.restarts;
}

void MatchReferee::archive(StateArchive& archive) {
  Referee::archive(archive);
  archive(halves_);
}

}  // namespace murosimf
