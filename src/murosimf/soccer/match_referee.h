#pragma once

/// @file The referee of a match: kick-offs, goals, balls put back, halves.
///
/// Kick-off  goes to the team that conceded. The other team waits until the ball is in play; its control software is
///           trusted to do so. A kick-off may go straight into the goal. Half-time is a pause like that after a goal;
///           the teams do not change sides.
/// Rules     of the ball: restart_rules.h. Play is not stopped when the ball is put back.
/// Clock     runs all the time, pauses included.

#include "murosimf/soccer/referee.h"

namespace murosimf {

class MatchReferee final : public Referee {
 public:
  /// Tells the robots of the match at once: make it after the control loop has been set and before the first frame.
  MatchReferee(const MatchSettings& match, Simulation& simulation);

  void archive(StateArchive& archive) override;
  bool inSecondHalf() const override { return halves_.second; }

 private:
  bool decide(Simulation& simulation) override;
  double timeLeft(long frame) const override;
  bool decideOnPhase(Simulation& simulation);
  void play(Simulation& simulation);
  void countGoal();
  void putBack(Simulation& simulation);
  bool isStuck(long frame);
  void checkClock(long frame);
  void kickOff(Simulation& simulation);
  void dropBall(Simulation& simulation, const Vector3& place, double gap);
  double halfLength() const { return match_.half_length > 0 ? match_.half_length : match_.duration; }

  struct Halves {
    bool second = false;
    long half_began = 0, rested_since = 0;  // [frames]
    Vector3 rest;                           // centre of the circle of kStuckDistance
  };
  Halves halves_;
  std::vector<Vector3> positions_;  // of the robots' bases, scratch
};

}  // namespace murosimf
