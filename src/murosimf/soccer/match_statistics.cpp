#include "murosimf/soccer/match_statistics.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

constexpr double kChordTime = 0.5;  // longer than one step of the walk [s]

}  // namespace

MatchStatistics::MatchStatistics(const Referee& referee, Simulation& simulation, const PerceptStatistics* percepts)
    : referee_(referee),
      percepts_(percepts),
      interventions_(simulation.interventions()),
      match_(referee.match()),
      ledger_(match_),
      kicks_(match_.robots.size()),
      walks_(match_.robots.size()),
      chord_(std::max(1L, std::lround(kChordTime / simulation.frameLength()))) {
  if (match_.ball.valid()) {
    ball_ = simulation.linked().handle(match_.ball, kBasePose);
    ball_velocity_ = simulation.linked().handle(match_.ball, kBodyVelocity);
  }
  for (const MatchRobot& robot : match_.robots) {
    paths_.emplace_back(simulation.linked(), robot.object);
    control_indices_.push_back(simulation.control() == nullptr ? -1 : simulation.control()->indexOf(robot.object));
  }
  touching_.reserve(match_.robots.size());
}

void MatchStatistics::afterFrame(Simulation& simulation) {
  readPlacements();
  if (simulation.frame() % chord_ == 0) measureWalks(simulation.frame());
  if (!ball_.valid()) return;
  readTouches(simulation.pairs());
  readKicks();
  BallMoment moment;
  moment.time = simulation.time();
  moment.playing = referee_.phase() == client::GamePhase::kPlaying;
  moment.in_play = referee_.ballInPlay();
  moment.ball = ball_.get().translation;
  moment.velocity = ball_velocity_.get();
  moment.touching = touching_;
  moment.kicks = kicks_;
  readReferee();
  ledger_.observe(moment);
}

void MatchStatistics::readTouches(const PairPhase& pairs) {
  touching_.clear();
  for (const PairPhase::Touch& touch : pairs.touches()) {
    if (touch.body != match_.ball) continue;
    for (std::size_t i = 0; i < match_.robots.size(); ++i) {
      const int robot = static_cast<int>(i);
      const bool new_one = std::find(touching_.begin(), touching_.end(), robot) == touching_.end();
      if (match_.robots[i].object == touch.partner && new_one) touching_.push_back(robot);
    }
  }
}

void MatchStatistics::readKicks() {
  if (percepts_ == nullptr) return;
  for (std::size_t i = 0; i < kicks_.size(); ++i) {
    if (control_indices_[i] >= 0) kicks_[i] = percepts_->kicksStarted(control_indices_[i]);
  }
}

void MatchStatistics::readReferee() {
  const std::vector<MatchEvent>& events = referee_.events();
  for (; events_read_ < events.size(); ++events_read_) {
    const MatchEvent& event = events[events_read_];
    if (event.kind == MatchEvent::Kind::kGoal) ledger_.goal(event.team, event.time);
  }
  if (referee_.restartCount() == restarts_read_) return;
  restarts_read_ = referee_.restartCount();
  ledger_.restart();
}

void MatchStatistics::readPlacements() {
  for (const InterventionQueue::Logged& entry : interventions_.applied()) {
    if (entry.intervention.kind != Intervention::Kind::kPlaceRobot) continue;
    for (std::size_t i = 0; i < match_.robots.size(); ++i) {
      if (match_.robots[i].object == entry.intervention.object) walks_[i].placed = entry.frame;
    }
  }
}

void MatchStatistics::measureWalks(long frame) {
  for (std::size_t i = 0; i < walks_.size(); ++i) {
    Walk& walk = walks_[i];
    const Vector3 base = paths_[i].position(0, paths_[i].shareAfter(frame - 1));
    // A placement shows when the robot's motion is stepped next, so one just before the chord began spoils it too.
    const bool placed = walk.placed + 2 * match_.control_period >= frame - chord_;
    const double x = base.x - walk.anchor.x, y = base.y - walk.anchor.y;
    if (!placed) walk.distance += sqrt(x * x + y * y);
    walk.anchor = base;
  }
}

MatchResult MatchStatistics::result() const {
  MatchResult result;
  const double frames = static_cast<double>(std::max(1L, ledger_.frames()));
  result.playing_share = static_cast<double>(ledger_.framesPlaying()) / frames;
  result.in_play_share = static_cast<double>(ledger_.framesInPlay()) / frames;
  result.last_touch[0] = ledger_.lastTouch(Team::kRed), result.last_touch[1] = ledger_.lastTouch(Team::kBlue);
  for (std::size_t i = 0; i < match_.robots.size(); ++i) {
    const MatchRobot& robot = match_.robots[i];
    result.robots.push_back(
        {robot.team, robot.number, walks_[i].distance, ledger_.counts(static_cast<int>(i)), kicks_[i]});
  }
  result.goals = ledger_.goals();
  return result;
}

void MatchStatistics::archive(StateArchive& archive) { archive(ledger_, walks_, kicks_, events_read_, restarts_read_); }

}  // namespace murosimf
