#include "murosimf/soccer/trial_referee.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/math/random.h"

namespace murosimf {

using client::GamePhase;

namespace {
constexpr std::uint64_t kScatterStream = 0x73636174;  // of random numbers
}

std::string nameOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kGoal:
      return "goal";
    case Outcome::kSaved:
      return "saved";
    case Outcome::kBeside:
      return "beside";
    case Outcome::kFinished:
      return "finished";
    case Outcome::kLeft:
      return "left the strip";
    case Outcome::kWrongSide:
      return "wrong side";
    case Outcome::kKnocked:
      return "knocked over";
    case Outcome::kTimeUp:
      return "time up";
  }
  return "";
}

TrialReferee::TrialReferee(const MatchSettings& match, Simulation& simulation) : Referee(match, simulation) {
  const auto found = std::find_if(match.robots.begin(), match.robots.end(),
                                  [&](const MatchRobot& robot) { return robot.team == match.kickoff_team; });
  if (found != match.robots.end()) attempter_ = static_cast<int>(found - match.robots.begin());
  attempts_.reserve(static_cast<std::size_t>(match.attempts));
  note(MatchEvent::Kind::kAttempt, match.kickoff_team, 0);
  if (match.scatter > 0 || match.scatter_heading > 0) putRobots(simulation);
  tellRobots(simulation, true);
}

bool TrialReferee::decide(Simulation& simulation) {
  const long frame = simulation.frame();
  switch (state_.phase) {
    case GamePhase::kReady:
      if (elapsed(frame) < match_.pause_after_goal) return false;
      putEverything(simulation);
      return true;
    case GamePhase::kSet:
      if (elapsed(frame) < kSetTime) return false;
      whistle(frame);
      startAnew();
      return false;
    case GamePhase::kPlaying: {
      checkKickedOff(frame);
      std::optional<Outcome> outcome = judge(simulation);
      if (!outcome && elapsed(frame) >= match_.time_limit) outcome = Outcome::kTimeUp;
      if (outcome) finishAttempt(simulation, *outcome);
      return false;
    }
    case GamePhase::kFinished:
      return false;
  }
  return false;
}

double TrialReferee::timeLeft(long frame) const {
  if (state_.phase != GamePhase::kPlaying) return match_.time_limit;
  return std::max(0.0, match_.time_limit - seconds(frame - state_.phase_began));
}

void TrialReferee::putRobots(Simulation& simulation) {
  for (std::size_t i = 0; i < match_.robots.size(); ++i) {
    const RandomStream random(match_.seed, simulation.world().path(match_.robots[i].object), kScatterStream);
    const std::uint64_t step = 3 * attempts_.size();
    const PlanarPose error{match_.scatter * random.normal(step), match_.scatter * random.normal(step + 1),
                           match_.scatter_heading * random.normal(step + 2)};
    putRobot(simulation, i, match_.robots[i].start, error);
  }
}

void TrialReferee::putEverything(Simulation& simulation) {
  putRobots(simulation);
  for (const MatchObstacle& obstacle : match_.obstacles) {
    if (obstacle.movable) simulation.interventions().placeRobot(simulation.frame(), obstacle.object, obstacle.start);
  }
  if (hasBall()) putBall(simulation, match_.ball_start);
  state_.kicked_off = state_.touched = false;
  ++state_.restarts;
  note(MatchEvent::Kind::kAttempt, match_.kickoff_team, simulation.time());
  begin(GamePhase::kSet, simulation.frame());
}

void TrialReferee::finishAttempt(Simulation& simulation, Outcome outcome) {
  const bool good = outcome == Outcome::kGoal || outcome == Outcome::kFinished;
  const bool faultless = match_.rules != Rules::kSlalom || faults_ == 0;
  const double time = seconds(simulation.frame() - state_.phase_began);
  attempts_.push_back({outcome, good && faultless, time, faults_});
  faults_ = 0;
  if (outcome == Outcome::kGoal) {
    ++state_.score[teamIndex(match_.kickoff_team)];
    note(MatchEvent::Kind::kGoal, match_.kickoff_team, state_.exit_time);
  }
  const bool last = static_cast<int>(attempts_.size()) >= match_.attempts;
  if (last) note(MatchEvent::Kind::kFinish, match_.kickoff_team, simulation.time());
  begin(last ? GamePhase::kFinished : GamePhase::kReady, simulation.frame());
}

int TrialReferee::passed() const {
  return static_cast<int>(std::count_if(attempts_.begin(), attempts_.end(), [](const Attempt& a) { return a.passed; }));
}

/// Of the attempt that goes on, of the one that was judged last while everybody is put back, and at the end of all.
std::string TrialReferee::scoreText() const {
  const std::size_t judged = attempts_.size();
  if (state_.phase == GamePhase::kFinished) return fmt::format("{} of {} attempts passed", passed(), judged);
  const bool pause = state_.phase == GamePhase::kReady && judged > 0;
  std::string text = fmt::format("attempt {} of {}", pause ? judged : judged + 1, match_.attempts);
  if (pause) text += ": " + nameOf(attempts_.back().outcome);
  const int faults = pause ? attempts_.back().faults : faults_;
  if (faults > 0) text += fmt::format(", {} {}", faults, faults == 1 ? "fault" : "faults");
  if (judged > 0) text += fmt::format("; {} passed", passed());
  return text;
}

void TrialReferee::archive(StateArchive& archive) {
  Referee::archive(archive);
  archive(faults_, attempts_);
}

}  // namespace murosimf
