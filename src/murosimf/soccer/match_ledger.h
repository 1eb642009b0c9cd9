#pragma once

/// @file Who touched the ball, who shot, who saved, who scored: told from the ball's motion and its touches.
///
/// Touch   A robot's touch lasts while it touches the ball again within 0.02 s. It is judged by the ball's velocity
///         before and after it; after 0.5 s it is judged even if it goes on.
/// Aim     The straight line of the ball's velocity meets the goal line between the posts (on target), or at most 0.5 m
///         beside one.
/// Shot    After the touch the ball is faster than 0.6 m/s and aims at the opponents' goal, and before it it was slower
///         or aimed elsewhere.
/// Save    A shot on target rolls; a robot of the defending team touches the ball; afterwards it is not on target.
/// Goal    An own goal when a robot of the team that conceded touched last. Deliberate when the scoring team's last
///         touch began at most 3 s after the toucher had started a kick; of own goals only when that touch was at most
///         5 s before the goal.

#include <array>
#include <span>
#include <vector>

#include "murosimf/math/state_archive.h"
#include "murosimf/soccer/match.h"

namespace murosimf {

inline constexpr double kTouchPause = 0.02, kLongestTouch = 0.5;                // [s]
inline constexpr double kShotSpeed = 0.6, kSlowSpeed = 0.1, kShotMargin = 0.5;  // [m/s], [m/s], [m]
inline constexpr double kKickBeforeTouch = 3.0, kDeflectedTime = 5.0;           // [s]

/// The match as it is at the end of one frame. Robots by their place in MatchSettings::robots.
struct BallMoment {
  double time = 0;                        ///< [s]
  bool playing = false, in_play = false;  ///< by the referee
  Vector3 ball, velocity;                 ///< of its centre, in W [m], [m/s]
  std::span<const int> touching;          ///< robots that touched the ball in this frame
  std::span<const std::uint32_t> kicks;   ///< deliberate kicks started so far, per robot; may be empty
};

struct LastTouch {
  int robot = -1;           ///< -1: none yet
  double time = -1e9;       ///< when it ended [s]
  bool after_kick = false;  ///< the robot had started a deliberate kick shortly before
};

struct BallCounts {
  int touches = 0, shots = 0, shots_on_target = 0, saves = 0, goals = 0, own_goals = 0;
};

struct GoalRecord {
  double time = 0;         ///< [s]
  Team team = Team::kRed;  ///< for which it counts
  int robot = -1;          ///< that touched the ball last; -1: nobody had
  bool own_goal = false, deliberate = false;
};

class MatchLedger {
 public:
  explicit MatchLedger(const MatchSettings& match);

  void observe(const BallMoment& moment);
  /// The ball has been put somewhere: what it did before says nothing any more.
  void restart();
  void goal(Team team, double time);
  void archive(StateArchive& archive);

  const BallCounts& counts(int robot) const { return counts_[static_cast<std::size_t>(robot)]; }
  const LastTouch& lastTouch(Team team) const { return state_.last[teamIndex(team)]; }
  const std::vector<GoalRecord>& goals() const { return goals_; }
  long framesPlaying() const { return state_.playing; }
  long framesInPlay() const { return state_.in_play; }
  long frames() const { return state_.frames; }

 private:
  struct Touching {  // the touch that goes on
    int robot = -1;
    double began = 0, last = 0;
    Vector3 velocity_before;
  };
  struct State {
    Touching touch;
    Vector3 velocity;           // in the frame before
    bool shot = false;          // a shot rolls...
    Team shot_by = Team::kRed;  // ...of this team
    bool shot_on_target = false;
    std::array<LastTouch, 2> last{};  // per team
    Team last_team = Team::kRed;
    long frames = 0, playing = 0, in_play = 0;
  };
  struct Kicks {
    std::uint32_t count = 0;
    double time = -1e9;  // of the last one [s]
  };

  void noteKicks(const BallMoment& moment);
  void follow(const BallMoment& moment);
  void beginTouch(const BallMoment& moment, int robot);
  void noteLast(const BallMoment& moment, int robot, bool begins);
  void judge(const BallMoment& moment);
  /// Distance beyond the posts at which the ball's line meets the goal line that `team` attacks: negative between them,
  /// infinite where it does not meet it.
  double aim(const BallMoment& moment, const Vector3& velocity, Team team) const;
  Team teamOf(int robot) const { return match_.robots[static_cast<std::size_t>(robot)].team; }

  MatchSettings match_;
  State state_;
  std::vector<Kicks> kicks_;
  std::vector<BallCounts> counts_;
  std::vector<GoalRecord> goals_;
};

}  // namespace murosimf
