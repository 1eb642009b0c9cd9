#include "murosimf/soccer/match_ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace murosimf {

namespace {

double speed(const Vector3& v) { return sqrt(v.x * v.x + v.y * v.y); }

}  // namespace

MatchLedger::MatchLedger(const MatchSettings& match)
    : match_(match), kicks_(match.robots.size()), counts_(match.robots.size()) {
  goals_.reserve(64);
}

void MatchLedger::observe(const BallMoment& moment) {
  ++state_.frames;
  state_.playing += moment.playing ? 1 : 0;
  state_.in_play += moment.in_play ? 1 : 0;
  noteKicks(moment);
  if (!moment.playing) {
    restart();
    return;
  }
  follow(moment);
  if (state_.shot && speed(moment.velocity) < kSlowSpeed && state_.touch.robot < 0) state_.shot = false;
  state_.velocity = moment.velocity;
}

void MatchLedger::noteKicks(const BallMoment& moment) {
  for (std::size_t i = 0; i < moment.kicks.size() && i < kicks_.size(); ++i) {
    if (moment.kicks[i] > kicks_[i].count) kicks_[i].time = moment.time;
    kicks_[i].count = moment.kicks[i];
  }
}

void MatchLedger::follow(const BallMoment& moment) {
  Touching& touch = state_.touch;
  const bool goes_on = std::find(moment.touching.begin(), moment.touching.end(), touch.robot) != moment.touching.end();
  if (goes_on) {
    touch.last = moment.time;
    noteLast(moment, touch.robot, false);
    if (moment.time - touch.began >= kLongestTouch) {
      judge(moment);
      touch.began = moment.time, touch.velocity_before = moment.velocity;
    }
    return;
  }
  if (!moment.touching.empty()) {
    if (touch.robot >= 0) judge(moment);
    beginTouch(moment, moment.touching.front());
  } else if (touch.robot >= 0 && moment.time - touch.last >= kTouchPause) {
    judge(moment);
    touch.robot = -1;
  }
}

void MatchLedger::beginTouch(const BallMoment& moment, int robot) {
  state_.touch = {robot, moment.time, moment.time, state_.velocity};
  ++counts_[static_cast<std::size_t>(robot)].touches;
  noteLast(moment, robot, true);
}

void MatchLedger::noteLast(const BallMoment& moment, int robot, bool begins) {
  state_.last_team = teamOf(robot);
  LastTouch& last = state_.last[teamIndex(state_.last_team)];
  const bool after_kick = moment.time - kicks_[static_cast<std::size_t>(robot)].time <= kKickBeforeTouch;
  last.after_kick = begins ? after_kick : last.after_kick || after_kick;
  last.robot = robot, last.time = moment.time;
}

void MatchLedger::judge(const BallMoment& moment) {
  const Touching& touch = state_.touch;
  const Team team = teamOf(touch.robot);
  BallCounts& counts = counts_[static_cast<std::size_t>(touch.robot)];
  if (state_.shot && state_.shot_by != team) {
    const bool still_on_target =
        speed(moment.velocity) >= kSlowSpeed && aim(moment, moment.velocity, state_.shot_by) < 0;
    if (state_.shot_on_target && !still_on_target) ++counts.saves;
    state_.shot = state_.shot_on_target = still_on_target;
  }
  const double aims = aim(moment, moment.velocity, team), aimed = aim(moment, touch.velocity_before, team);
  const bool was_shot = speed(touch.velocity_before) > kShotSpeed && aimed <= kShotMargin;
  const bool is_shot = speed(moment.velocity) > kShotSpeed && aims <= kShotMargin;
  if (is_shot && !was_shot) {
    ++counts.shots;
    counts.shots_on_target += aims < 0 ? 1 : 0;
  }
  if (is_shot) state_.shot = true, state_.shot_by = team, state_.shot_on_target = aims < 0;
  if (!is_shot && state_.shot_by == team) state_.shot = false;
}

double MatchLedger::aim(const BallMoment& moment, const Vector3& velocity, Team team) const {
  const bool plus = attacksPositiveX(match_, team);
  const Vector3 p = turnedForTeam(moment.ball, plus), v = turnedForTeam(velocity, plus);
  const double way = match_.field.length / 2 - p.x;
  if (way < 0 || v.x <= 1e-9) return std::numeric_limits<double>::infinity();
  return std::fabs(p.y + v.y * (way / v.x)) - match_.field.goal_width / 2;
}

void MatchLedger::restart() {
  state_.touch = {};
  state_.velocity = {};
  state_.shot = false;
}

void MatchLedger::goal(Team team, double time) {
  GoalRecord record{time, team, -1, false, false};
  const LastTouch& touch = lastTouch(team);
  const int last = state_.last[teamIndex(state_.last_team)].robot;
  record.robot = last;
  record.own_goal = last >= 0 && state_.last_team != team;
  record.deliberate = touch.robot >= 0 && touch.after_kick && (!record.own_goal || time - touch.time <= kDeflectedTime);
  if (last >= 0)
    ++(record.own_goal ? counts_[static_cast<std::size_t>(last)].own_goals
                       : counts_[static_cast<std::size_t>(last)].goals);
  goals_.push_back(record);
}

void MatchLedger::archive(StateArchive& archive) { archive(state_, kicks_, counts_, goals_); }

}  // namespace murosimf
