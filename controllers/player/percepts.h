#pragma once

/// @file What the vision finds in one sensor frame's pictures, in the robot's ground frame R.
///
/// R: origin on the ground below the middle of the hips, x in the pelvis' heading, z up.

#include <vector>

#include "murosimf/control/client/robot_frames.h"

namespace murosimf::controllers {

enum class LandmarkColour : std::uint8_t { kYellow, kBlue };

struct BallPercept {
  double x = 0, y = 0;   ///< point on the ground below the ball's centre, in R [m]
  double deviation = 0;  ///< standard deviation of the distance [m]
};

/// A goal post (colour: the goal's) or a landmark pole (colour: its top segment's).
struct LandmarkPercept {
  LandmarkColour colour = LandmarkColour::kYellow;
  double bearing = 0;   ///< in R [rad], positive to the left
  double distance = 0;  ///< horizontal, to the axis of the post [m]
  double bearing_deviation = 0.02, distance_deviation = 0.1;
  bool foot_seen = false;  ///< distance from the foot point rather than from the width
};

struct LinePercept {
  double x = 0, y = 0;  ///< a point on the middle of a white line, in R [m]
  double normal = 0;    ///< direction across the line in R [rad], modulo pi
};

struct RobotPercept {
  double x = 0, y = 0;  ///< foot point of another robot, in R [m]
};

/// A red obstacle on the ground.
struct ObstaclePercept {
  double x = 0, y = 0;  ///< its middle, in R [m]
};

struct Percepts {
  std::vector<BallPercept> balls;  ///< best first; usually none or one
  std::vector<LandmarkPercept> posts, poles;
  std::vector<LinePercept> lines;
  std::vector<RobotPercept> robots;
  std::vector<ObstaclePercept> obstacles;
  std::vector<client::Percept> drawn;  ///< the same in picture coordinates, for the report
  void clear() {
    balls.clear(), posts.clear(), poles.clear(), lines.clear(), robots.clear(), obstacles.clear(), drawn.clear();
  }
};

}  // namespace murosimf::controllers
