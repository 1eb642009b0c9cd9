#pragma once

/// @file What the behaviour decides from, gathered once a step.
///
/// Frames: R the robot's ground frame (below the hips, x ahead), F the field in the team's own frame (+x: the goal
/// that the team attacks, origin in the centre).

#include <span>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "plane.h"
#include "walking_engine.h"

namespace murosimf::controllers {

enum class Role : std::uint8_t { kKeeper, kDefender, kStriker, kRunner };

struct Situation {
  double time = 0, dt = 0.01;  ///< [s]
  client::GameInfo game;
  Role role = Role::kStriker;
  int wing = 0;  ///< 1 left, -1 right, 0 the middle
  int number = 1;

  PlanarPose X_FR;                ///< where the robot believes to stand
  double position_deviation = 0;  ///< that the localisation claims [m]

  bool ball_known = false;  ///< seen by the robot itself, recently
  double ball_age = 1e9;    ///< since it was seen [s]
  Point ball_R;             ///< [m]
  Point ball_velocity_R;    ///< over the ground [m/s]

  bool team_ball_known = false;  ///< seen by some mate
  double team_ball_age = 1e9;    ///< [s]
  Point team_ball_F;             ///< [m]

  std::span<const client::TeamMessage> mates;  ///< heard of in the last second
  std::span<const Point> robots_R;             ///< other robots, seen or heard of
  std::span<const Point> obstacles_R;          ///< the same, goal posts, and obstacles of a course

  std::span<const Point> course_R;  ///< obstacles of a course

  bool fallen = false;   ///< the body lies or gets up
  bool settled = false;  ///< the body stands still
  bool kicking = false;
  WalkCommand velocity;  ///< at which the body walks now
  double kick_time = 0;  ///< since the kick began [s]

  Point ball_F() const { return transformed(X_FR, ball_R); }
};

/// The numbers of the field that decisions need; all in F.
struct Pitch {
  double half_length = 0, half_width = 0, half_goal = 0;
  double ball_radius = 0, post_radius = 0;

  static Pitch of(const client::FieldDescription& field) {
    return {0.5 * field.length, 0.5 * field.width, 0.5 * field.goal_width, field.ball_radius, field.post_radius};
  }
  Point attackedGoal() const { return {half_length, 0}; }
  Point ownGoal() const { return {-half_length, 0}; }
};

}  // namespace murosimf::controllers
