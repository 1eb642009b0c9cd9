#pragma once

/// @file The referee: clock, kick-offs, goals, balls put back. Acts through interventions and the game's broadcast.
///
/// Phases    kSet (1 s: robots and ball stand at their places) -> kPlaying -> after a goal kReady (a pause) ->
/// everybody
///           is put at the kick-off places -> kSet ... -> kFinished. The match begins in kSet with the robots where the
///           scenario put them. Half-time is a pause like that after a goal; the teams do not change sides.
/// Kick-off  goes to the team that conceded. The other team waits until the ball is in play; its control software is
///           trusted to do so. A kick-off may go straight into the goal.
/// Rules     of the ball: restart_rules.h. Play is not stopped when the ball is put back.
/// Clock     runs all the time, pauses included.
/// Rhythm    The ball is watched in every frame. The referee acts where a control period begins, so a placement made
///           there is seen whole by the next sensor frame, and that one alone says `placed`.
/// State     archived; a continued run goes on with the same match.

#include <array>
#include <vector>

#include "murosimf/linking/body_path.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/soccer/restart_rules.h"

namespace murosimf {

/// Something worth a line in the report.
struct MatchEvent {
  enum class Kind : std::uint8_t { kKickoff, kGoal, kTouchLine, kGoalLine, kStuck, kHalfTime, kFinish };
  Kind kind = Kind::kKickoff;
  Team team = Team::kRed;  ///< that kicks off, scored, or touched the ball last
  double time = 0;         ///< [s]
  Vector3 place;           ///< of the ball [m]
};

class Referee final : public FrameObserver {
 public:
  /// Tells the robots of the match at once: make it after the control loop has been set and before the first frame.
  Referee(const MatchSettings& match, Simulation& simulation);

  void afterFrame(Simulation& simulation) override;
  void archive(StateArchive& archive) override;

  const MatchSettings& match() const { return match_; }
  client::GamePhase phase() const { return state_.phase; }
  /// The ball has been kicked off and no goal has been scored since.
  bool ballInPlay() const { return state_.phase == client::GamePhase::kPlaying && state_.kicked_off; }
  Team kickoffTeam() const { return state_.kickoff_team; }
  int score(Team team) const { return state_.score[teamIndex(team)]; }
  /// Kick-offs and balls put back so far, the first kick-off included.
  std::uint32_t restartCount() const { return state_.restarts; }
  const std::vector<MatchEvent>& events() const { return events_; }

 private:
  struct State {
    client::GamePhase phase = client::GamePhase::kSet;
    Team kickoff_team = Team::kRed;
    bool kicked_off = false;
    bool touched = false;    // by anybody since the kick-off...
    Team last = Team::kRed;  // ...last by this team
    bool second_half = false;
    std::uint32_t restarts = 1;
    std::array<int, 2> score{};
    long phase_began = 0, half_began = 0, rested_since = 0;  // [frames]
    Vector3 ball, mark, rest;  // now, at the kick-off, centre of the circle of kStuckDistance
    BallExit exit;             // seen, not acted upon yet
    double exit_time = 0;      // [s]
  };

  void watchBall(Simulation& simulation);
  /// What is decided in each phase. @returns true when the robots have been put somewhere
  bool decide(Simulation& simulation);
  void play(Simulation& simulation);
  void countGoal();
  void putBack(Simulation& simulation);
  bool isStuck(long frame);
  void checkClock(long frame);
  void kickOff(Simulation& simulation);
  void begin(client::GamePhase phase, long frame);
  void putBall(Simulation& simulation, const Vector3& place, double gap);
  void tellRobots(Simulation& simulation, bool placed) const;
  void note(MatchEvent::Kind kind, Team team, double time);
  double seconds(long frames) const { return static_cast<double>(frames) * frame_length_; }
  double halfLength() const { return match_.half_length > 0 ? match_.half_length : match_.duration; }

  MatchSettings match_;
  double frame_length_;
  Handle<Pose> ball_;
  std::vector<BodyPath> paths_;       // of the robots
  std::vector<int> control_indices_;  // -1: nobody controls it
  std::vector<PlanarPose> places_;    // where the robots were put last
  std::vector<Vector3> positions_;    // of the robots' bases, scratch
  State state_;
  std::vector<MatchEvent> events_;
};

}  // namespace murosimf
