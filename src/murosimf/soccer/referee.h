#pragma once

/// @file What all referees do: they watch the ball, keep the phases, put robots and ball to their places and tell the
/// robots how the game stands. Act through interventions and the game's broadcast.
///
/// Phases    kSet (1 s: robots and ball stand at their places) -> kPlaying -> kReady (a pause) -> everybody is put to
///           a place -> kSet ... -> kFinished. A game begins in kSet with the robots where the scenario put them. What
///           ends kPlaying and the game is up to the rules: match_referee.h, penalty_referee.h, course_referee.h.
/// Beams     A program may choose its robot's place in kSet and kReady (CommandFrame::beam): in its own half, on the
///           field or its border. Elsewhere, and while the ball is in play, it is left where it is.
/// Rhythm    The ball is watched in every frame. The referee acts where a control period begins, so a placement made
///           there is seen whole by the next sensor frame, and that one alone says `placed`.
/// State     archived; a continued run goes on with the same game.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/linking/body_path.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/soccer/restart_rules.h"

namespace murosimf {

/// Something worth a line in the report.
struct MatchEvent {
  enum class Kind : std::uint8_t { kKickoff, kGoal, kTouchLine, kGoalLine, kStuck, kHalfTime, kFinish, kAttempt };
  Kind kind = Kind::kKickoff;
  Team team = Team::kRed;  ///< that kicks off, scored, touched the ball last, or attempts
  double time = 0;         ///< [s]
  Vector3 place;           ///< of the ball [m]
};

inline constexpr double kSetTime = 1.0;  ///< between placing everybody and the whistle [s]

class Referee : public FrameObserver {
 public:
  void afterFrame(Simulation& simulation) final;
  void archive(StateArchive& archive) override;
  /// How the game stands, for people: "red 1 : 0 blue".
  virtual std::string scoreText() const;

  const MatchSettings& match() const { return match_; }
  client::GamePhase phase() const { return state_.phase; }
  /// The ball has been kicked off, and play has not been ended since.
  bool ballInPlay() const { return state_.phase == client::GamePhase::kPlaying && state_.kicked_off; }
  Team kickoffTeam() const { return state_.kickoff_team; }
  /// Of the half or of the attempt, at the end of the frame before this one [s].
  double secondsLeft(long frame) const { return timeLeft(frame); }
  virtual bool inSecondHalf() const { return false; }
  int score(Team team) const { return state_.score[teamIndex(team)]; }
  /// Kick-offs, attempts and balls put back so far, the first kick-off included.
  std::uint32_t restartCount() const { return state_.restarts; }
  const std::vector<MatchEvent>& events() const { return events_; }

 protected:
  Referee(const MatchSettings& match, Simulation& simulation);

  /// What the rules say where a control period begins. @returns true when the robots have been put somewhere
  virtual bool decide(Simulation& simulation) = 0;
  /// Of the half or of the attempt [s].
  virtual double timeLeft(long frame) const = 0;

  struct State {
    client::GamePhase phase = client::GamePhase::kSet;
    Team kickoff_team = Team::kRed;
    bool kicked_off = false;
    bool touched = false;    // by anybody since the kick-off...
    Team last = Team::kRed;  // ...last by this team
    std::uint32_t restarts = 1;
    std::array<int, 2> score{};
    long phase_began = 0;  // [frames]
    Vector3 ball, mark;    // now, at the kick-off
    BallExit exit;         // seen, not acted upon yet
    double exit_time = 0;  // [s]
  };

  /// Tells the robots of the game, which the last constructor must do before the first frame.
  void tellRobots(Simulation& simulation, bool placed) const;
  void begin(client::GamePhase phase, long frame);
  /// The whistle: play begins with the ball where it is.
  void whistle(long frame);
  /// The ball counts as in play once it has moved, or after the wait.
  void checkKickedOff(long frame);
  /// @param error  of who puts it there, in its own axes; the robot is told of `place`
  void putRobot(Simulation& simulation, std::size_t robot, const PlanarPose& place, const PlanarPose& error = {});
  void putBall(Simulation& simulation, const Vector3& place);
  void note(MatchEvent::Kind kind, Team team, double time);
  double seconds(long frames) const { return static_cast<double>(frames) * frame_length_; }
  /// Since the phase began, with half a frame for what is rounded [s].
  double elapsed(long frame) const { return seconds(frame - state_.phase_began) + frame_length_ / 2; }
  bool hasBall() const { return ball_.valid(); }
  Vector3 ballVelocity() const { return ball_velocity_.get(); }
  /// p_WB of a robot's base at the end of the last frame.
  Vector3 position(std::size_t robot, const Simulation& simulation) const;

  MatchSettings match_;
  State state_;

 private:
  void watchBall(Simulation& simulation);
  /// Puts robots where their programs ask to be put, as long as play has not begun, and notes which.
  void obeyBeams(Simulation& simulation);

  double frame_length_;
  Handle<Pose> ball_;
  Handle<Vector3> ball_velocity_;
  std::vector<BodyPath> paths_;       // of the robots
  std::vector<int> control_indices_;  // -1: nobody controls it
  std::vector<PlanarPose> places_;    // where the robots were said to have been put last
  std::vector<std::uint8_t> beamed_;  // 1: by a beam, in this control period
  std::vector<MatchEvent> events_;
};

/// The referee for the rules of the settings.
std::unique_ptr<Referee> makeReferee(const MatchSettings& match, Simulation& simulation);

}  // namespace murosimf
