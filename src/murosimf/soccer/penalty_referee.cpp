#include "murosimf/soccer/penalty_referee.h"

namespace murosimf {

std::optional<Outcome> PenaltyReferee::judge(Simulation& simulation) {
  if (!hasBall()) return std::nullopt;
  const bool attacked = (state_.exit.side > 0) == attacksPositiveX(match_, match_.kickoff_team);
  if (state_.exit.kind == BallExit::Kind::kGoal && attacked) return Outcome::kGoal;
  if (state_.exit.kind != BallExit::Kind::kNone) return keeperTouchedLast() ? Outcome::kSaved : Outcome::kBeside;
  const bool rolls = squaredNorm(ballVelocity()) > kRestSpeed * kRestSpeed;
  if (rolls || !keeperTouchedLast()) rolled_ = simulation.frame();
  if (seconds(simulation.frame() - rolled_) >= kRestTime) return Outcome::kSaved;
  return std::nullopt;
}

void PenaltyReferee::archive(StateArchive& archive) {
  TrialReferee::archive(archive);
  archive(rolled_);
}

}  // namespace murosimf
