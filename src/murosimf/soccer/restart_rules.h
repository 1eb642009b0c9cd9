#pragma once

/// @file The rules of play as functions: when the ball is out or in the goal, and where it and the robots are put.
///
/// A simple set in the manner of the RoboCup humanoid league of 2007:
///   Goal        The whole ball is behind the goal line's outer edge, and passed it between the posts below the bar.
///   Touch line  The whole ball is outside. It is put 0.3 m inside the line where it left. Play goes on.
///   Goal line   The whole ball is behind it beside or over the goal. Last touched by a defender: put 0.4 m before the
///               goal line (corner); else 1 m before it (goal kick); both 0.5 m inside the nearer touch line.
///   Stuck       A ball that has not left a circle of 5 cm for 30 s is dropped on the centre mark.
/// A ball is put at least 0.3 m (dropped: 0.5 m) from every robot: the place is moved if need be.

#include <span>

#include "murosimf/soccer/match.h"

namespace murosimf {

inline constexpr double kThrowInInside = 0.3, kCornerDistance = 0.4, kGoalKickDistance = 1.0;  // [m]
inline constexpr double kCornerInside = 0.5, kFieldMargin = 0.3;                               // [m]
inline constexpr double kRestartGap = 0.3, kDropGap = 0.5, kKickoffGap = 0.15;  // from the ball to a robot's base [m]
inline constexpr double kStuckDistance = 0.05, kStuckTime = 30;                 // [m], [s]

/// How the ball left the field.
struct BallExit {
  enum class Kind : std::uint8_t { kNone, kGoal, kGoalLine, kTouchLine };
  Kind kind = Kind::kNone;
  double side = 0;  ///< kGoal, kGoalLine: sign of x; kTouchLine: sign of y
  Vector3 place;    ///< p_W of the ball's centre when the last of it passed the line [m]
};

/// Looks at the straight path of the ball's centre over one frame. A path that begins outside is judged by its end.
BallExit judgeExit(const client::FieldDescription& field, const Vector3& before, const Vector3& after);

/// Where a ball that left over a touch line or a goal line is put, before robots are looked at; z = 0.
Vector3 restartPlace(const client::FieldDescription& field, const BallExit& exit, bool touched_by_defender);

/// The place itself or the nearest on rings around it that is in the field and `gap` from all robots; first tried
/// towards the field's centre. The place itself when everything is crowded. z is ignored, and 0 in the result.
Vector3 freePlace(const client::FieldDescription& field, const Vector3& place, std::span<const Vector3> robots,
                  double gap);

/// X_WB at a kick-off: what the scenario says, else the start pose moved back into the own half and, when the others
/// kick off, out of the centre circle.
PlanarPose kickoffPose(const MatchSettings& match, const MatchRobot& robot, Team kickoff_team);

}  // namespace murosimf
