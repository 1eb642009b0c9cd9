#pragma once

/// @file What the player believes: where it stands and where the ball is.

#include <array>

#include "murosimf/control/client/state_archive.h"
#include "percepts.h"

namespace murosimf::controllers {

/// Self-localisation on the field in the team's own frame (+x: towards the goal attacked).
class Localisation {
 public:
  void start(const client::RobotDescription& robot);
  /// The robot was put somewhere by hand and told so.
  void place(const PlanarPose& pose);
  /// Moves by one odometry increment (pose of the new R in the old R).
  void move(const PlanarPose& increment);
  /// Corrects by landmarks and lines.
  void observe(const Percepts& percepts);
  PlanarPose pose() const;
  /// Standard deviations of position [m] and heading [rad] that the estimate claims.
  double positionDeviation() const;
  double headingDeviation() const;
  void archive(client::StateArchive& archive);

 private:
  // state is the author's choice
};

/// The ball in the robot's frame R, with velocity.
class BallModel {
 public:
  void start(const client::RobotDescription& robot);
  void move(const PlanarPose& increment, double dt);
  void observe(const Percepts& percepts);
  bool known() const;        ///< seen recently enough to act on
  double age() const;        ///< since it was last seen [s]
  Vector3 position() const;  ///< x, y in R [m], z 0
  Vector3 velocity() const;  ///< x, y in R's axes [m/s], of the ball over the ground
  void forget();
  void archive(client::StateArchive& archive);

 private:
};

}  // namespace murosimf::controllers
