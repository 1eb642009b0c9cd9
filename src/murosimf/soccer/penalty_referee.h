#pragma once

/// @file The referee of penalty kicks, one after the other, after [RoboCup Humanoid League rules 2025, law 14].
///
/// Kick      The team that has the kick-off kicks; its opponents' keeper is trusted to stand still until the ball is
///           in play. Ours: the kicker may play the ball again until the time is up.
/// End       The ball is in the goal; behind a line; or the keeper's team touched it last and it is at rest again.
/// Saved     The ball stayed out of the goal, and the keeper's team touched it last.

#include "murosimf/soccer/trial_referee.h"

namespace murosimf {

/// A ball slower than this for so long is at rest [m/s], [s].
inline constexpr double kRestSpeed = 0.03, kRestTime = 0.5;

class PenaltyReferee final : public TrialReferee {
 public:
  PenaltyReferee(const MatchSettings& match, Simulation& simulation) : TrialReferee(match, simulation) {}

  void archive(StateArchive& archive) override;

 private:
  std::optional<Outcome> judge(Simulation& simulation) override;
  void startAnew() override { rolled_ = 0; }
  bool keeperTouchedLast() const { return state_.touched && state_.last != match_.kickoff_team; }

  long rolled_ = 0;  // frame in which the ball rolled last
};

}  // namespace murosimf
