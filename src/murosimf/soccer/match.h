#pragma once

/// @file A match in plain words: who plays, on what field, under which numbers. Filled by whoever reads scenarios.
///
/// Frames: W the field (origin at its centre, +x along the longer side, z up). A team's own frame F is W for the team
/// that attacks +x and W turned by pi about z for the other one, so that +x is always the goal attacked.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/world/world.h"

namespace murosimf {

enum class Team : std::uint8_t { kRed, kBlue };

inline constexpr Team otherTeam(Team team) { return team == Team::kRed ? Team::kBlue : Team::kRed; }
/// Place of a team in arrays of two.
inline constexpr std::size_t teamIndex(Team team) { return team == Team::kRed ? 0 : 1; }
inline constexpr const char* teamName(Team team) { return team == Team::kRed ? "red" : "blue"; }

/// What the referee judges: match_referee.h, penalty_referee.h, course_referee.h.
enum class Rules : std::uint8_t { kMatch, kPenaltyKicks, kSlalom, kObstacleRun };

/// Something that stands in the way, upright.
struct MatchObstacle {
  ObjectId object;
  PlanarPose start;      ///< X_WB in the first frame
  bool movable = false;  ///< else it stands fast
};

/// The way of a slalom or of an obstacle run (client::CourseDescription says more).
struct Course {
  PlanarPose X_WC;                   ///< origin in the middle of the start line, x along the way
  double length = 0, width = 0;      ///< [m]; width 0: no limit
  bool first_passed_on_left = true;  ///< of the poles of a slalom
};

struct MatchRobot {
  ObjectId object;
  Team team = Team::kRed;
  int number = 0;                                        ///< jersey number from 1
  PlanarPose start;                                      ///< X_WB in the first frame
  std::optional<PlanarPose> kickoff_own, kickoff_other;  ///< X_WB; absent: kickoffPose() of restart_rules.h chooses
};

struct MatchSettings {
  Rules rules = Rules::kMatch;
  client::FieldDescription field;  ///< with the ball's radius
  ObjectId ball;                   ///< invalid: a match without a ball has a clock and nothing else
  bool red_attacks_positive_x = true;
  std::vector<MatchRobot> robots;

  Team kickoff_team = Team::kRed;  ///< has the first kick-off
  double kickoff_wait = 10;        ///< the ball counts as in play after this even if it rests on its mark [s]
  double ball_moved = 0.05;        ///< or when it has moved this far from the mark [m]
  double pause_after_goal = 2;     ///< [s]; before the second half and the next attempt as well
  double half_length = 0;          ///< [s], two halves; 0: one half that lasts as long as the run
  double duration = 60;            ///< of the run [s]
  int attempts = 1;                ///< of all rules but the match's
  double time_limit = 60;          ///< of an attempt [s]
  double scatter = 0;              ///< of the robots' places at its beginning, standard deviation [m] ...
  double scatter_heading = 0;      ///< ... and of their headings [rad]; the robots are told of neither
  std::uint64_t seed = 1;          ///< of these
  Vector3 ball_start;              ///< where an attempt begins with it [m]
  Course course;
  std::vector<MatchObstacle> obstacles;
  long control_period = 10;  ///< frames between two sensor frames of a robot: the referee acts only then
};

inline bool attacksPositiveX(const MatchSettings& match, Team team) {
  return (team == Team::kRed) == match.red_attacks_positive_x;
}
/// A place, velocity or pose of W in the frame F of a team, and back: both turns are the same.
inline Vector3 turnedForTeam(const Vector3& p, bool attacks_positive_x) {
  return attacks_positive_x ? p : Vector3{-p.x, -p.y, p.z};
}
inline PlanarPose turnedForTeam(const PlanarPose& p, bool attacks_positive_x) {
  return attacks_positive_x ? p : PlanarPose{-p.x, -p.y, wrapAngle(p.heading + kPi)};
}

}  // namespace murosimf
