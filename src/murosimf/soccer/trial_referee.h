#pragma once

/// @file The referee of trials: the same situation again and again, each time judged.
///
/// Attempt   Everybody and everything is put to where the scenario has it; after the whistle the rules watch until they
///           have judged or the time is up; then a pause, and the next one. The game is finished after the last.
/// Scatter   Nobody puts a robot exactly where it should stand: its place and heading are off a little, differently in
///           each attempt, and it is not told.
/// Who       The first robot of the team that has the kick-off attempts; whatever others there are take part.

#include <optional>

#include "murosimf/soccer/referee.h"

namespace murosimf {

/// How an attempt ended.
enum class Outcome : std::uint8_t {
  kGoal,
  kSaved,
  kBeside,     ///< over the goal line beside the goal, or over a touch line
  kFinished,   ///< the finish line was crossed
  kLeft,       ///< the strip was left
  kWrongSide,  ///< a pole was passed on the wrong side
  kKnocked,    ///< an obstacle was knocked over
  kTimeUp
};
/// "goal", "time up", ...
std::string nameOf(Outcome outcome);

struct Attempt {
  Outcome outcome = Outcome::kTimeUp;
  bool passed = false;
  double time = 0;  ///< from the whistle to the end [s]
  int faults = 0;   ///< obstacles touched, each time anew
};

class TrialReferee : public Referee {
 public:
  const std::vector<Attempt>& attempts() const { return attempts_; }
  int passed() const;
  std::string scoreText() const override;
  void archive(StateArchive& archive) override;

 protected:
  TrialReferee(const MatchSettings& match, Simulation& simulation);

  /// Looks at what happened since the control period before. @returns how the attempt ended, if it did
  virtual std::optional<Outcome> judge(Simulation& simulation) = 0;
  /// A new attempt begins.
  virtual void startAnew() = 0;
  void countFault() { ++faults_; }
  /// Its place in MatchSettings::robots; -1: there is none.
  int attempter() const { return attempter_; }

 private:
  bool decide(Simulation& simulation) final;
  double timeLeft(long frame) const final;
  void putEverything(Simulation& simulation);
  void putRobots(Simulation& simulation);
  void finishAttempt(Simulation& simulation, Outcome outcome);

  int attempter_ = -1;
  int faults_ = 0;  // of the attempt
  std::vector<Attempt> attempts_;
};

}  // namespace murosimf
