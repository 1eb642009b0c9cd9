#pragma once

/// @file How a cart plays: it goes behind the ball and pushes it to the goal.
///
/// It needs to know where it stands (level "oracle" of localisation) and to see the ball (a camera of level "oracle");
/// between these its odometry goes on. Without a place it rests; without a ball it turns about itself, and then goes to
/// the middle of the field's own half. At the other team's kick-off it waits until the ball has moved. A keeper stays
/// before its goal on the line to the ball, and pushes it away when it is near.

#include <optional>

#include "cart_task.h"
#include "laser_guard.h"
#include "murosimf/control/client/control_software.h"

namespace murosimf::controllers::cart {

class BallPlay {
 public:
  void describe(const client::RobotDescription& robot, bool omnidirectional);
  /// One control period: what it saw, and how the base has moved.
  void see(const client::SensorFrame& sensors, const BaseMotion& way);
  /// The velocity of the base that play asks for.
  BaseMotion play(const client::SensorFrame& sensors, LaserGuard& guard);

  const char* activity() const { return activity_; }
  bool placed() const { return pose_known_; }
  const Place& pose() const { return pose_; }  ///< in the team's own frame
  std::optional<GroundPoint> ball() const;     ///< on the base
  void archive(client::StateArchive& archive);

 private:
  struct Target {
    double x = 0, y = 0, heading = 0, speed = 0.4;
  };
  void seeBall(const client::SensorFrame& sensors);
  bool waits(const client::SensorFrame& sensors);
  BaseMotion chase(LaserGuard& guard);
  BaseMotion push(double heading, double aside) const;
  BaseMotion search(double period);
  BaseMotion keep(LaserGuard& guard);
  BaseMotion goTo(const Target& target, LaserGuard& guard);

  client::RobotDescription robot_;
  bool omnidirectional_ = false, keeper_ = false;
  const char* activity_ = "rest";

  bool pose_known_ = false, ball_known_ = false, pushing_ = false, waiting_ = false;
  Place pose_;
  double ball_x_ = 0, ball_y_ = 0;        // in the team's own frame
  double ball_age_ = 0, searched_ = 0;    // [s]
  double kickoff_x_ = 0, kickoff_y_ = 0;  // of the ball when the wait began
  bool kickoff_seen_ = false;
  double waited_ = 0;
  std::uint32_t restarts_ = 0xffffffffU;
};

}  // namespace murosimf::controllers::cart
