#pragma once

/// @file Figures of a match for its report: ways walked, touches, shots, saves, goals, share of time in play.
///
/// Distance walked is the length of the base's path in the ground plane over chords of 0.5 s, so that the trunk's sway
/// at each step does not count; chords in which the robot was put somewhere are left out.
/// What the ball tells: match_ledger.h.

#include <vector>

#include "murosimf/linking/body_path.h"
#include "murosimf/soccer/match_ledger.h"
#include "murosimf/soccer/percept_statistics.h"
#include "murosimf/soccer/referee.h"

namespace murosimf {

struct RobotStatistics {
  Team team = Team::kRed;
  int number = 0;
  double distance_walked = 0;  ///< [m]
  BallCounts ball;
  std::uint32_t kicks = 0;  ///< deliberate kicks started, as its software says
};

struct MatchResult {
  double playing_share = 0;  ///< share of time in which the game was on [1]
  double in_play_share = 0;  ///< share of time in which the ball was in play: kicked off, no goal yet [1]
  LastTouch last_touch[2];   ///< red, blue; robots by their place in `robots`
  std::vector<RobotStatistics> robots;
  std::vector<GoalRecord> goals;
};

/// Observe the simulation with the referee first, then with this.
class MatchStatistics final : public FrameObserver {
 public:
  /// `percepts` tells of deliberate kicks; null: no goal is deliberate.
  MatchStatistics(const Referee& referee, Simulation& simulation, const PerceptStatistics* percepts = nullptr);

  void afterFrame(Simulation& simulation) override;
  void archive(StateArchive& archive) override;
  MatchResult result() const;

 private:
  struct Walk {
    Vector3 anchor;  // where the chord began
    double distance = 0;
    long placed = 0;  // frame in which somebody put the robot last
  };
  void readTouches(const PairPhase& pairs);
  void readKicks();
  void readPlacements();
  void readReferee();
  void measureWalks(long frame);

  const Referee& referee_;
  const PerceptStatistics* percepts_;
  const InterventionQueue& interventions_;
  MatchSettings match_;
  MatchLedger ledger_;
  Handle<Pose> ball_;
  Handle<Vector3> ball_velocity_;
  std::vector<BodyPath> paths_;
  std::vector<int> control_indices_;
  std::vector<int> touching_;         // scratch
  std::vector<std::uint32_t> kicks_;  // per robot
  std::vector<Walk> walks_;
  long chord_;  // [frames]
  std::size_t events_read_ = 0;
  std::uint32_t restarts_read_ = 1;
};

}  // namespace murosimf
