#pragma once

/// @file Control software of robots on wheels, whatever their drive: it drives as its role says, or plays.
///
/// Each control period: odometry from the wheels' angles; a velocity of the base from the plan (cart_task.h) or from
/// play (ball_play.h), which goes around what the laser scanner sees (laser_guard.h); after a bumper has touched what
/// is not the ball, a short way back. Velocities change no faster than tyres can follow, and become rates of wheels
/// (wheel_drive.h), which are commanded with kp = 0 and kd > 0.

#include <memory>
#include <vector>

#include "ball_play.h"
#include "cart_task.h"
#include "laser_guard.h"
#include "murosimf/control/client/control_software.h"
#include "wheel_drive.h"

namespace murosimf::controllers::cart {

class Cart final : public client::ControlSoftware {
 public:
  /// @throws std::invalid_argument for a robot that its wheels cannot drive, and for a role that is no plan
  void start(const client::RobotDescription& robot) override;
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override;
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive& archive) override;

  /// Where odometry says that it is, from where it was put.
  const Place& odometry() const { return odometry_; }

 private:
  BaseMotion wanted(const client::SensorFrame& sensors);
  bool backsOff(const client::SensorFrame& sensors, BaseMotion& velocity);
  void ramp(const BaseMotion& wanted);
  void tell();

  double period_ = 0.01;  ///< of control [s]
  CartPlan plan_;
  WheelDrive drive_;
  LaserGuard guard_;
  BallPlay play_;
  SquareDriver square_;
  std::vector<client::TouchSensorDescription> bumpers_;
  std::vector<double> wheel_angles_;  // of the last step; empty before the first
  Place odometry_;
  BaseMotion velocity_;               // commanded
  double backing_ = 0, back_to_ = 0;  // time left [s], direction of the bumper
  client::ControlReport report_;
};

std::unique_ptr<client::ControlSoftware> makeCart();

}  // namespace murosimf::controllers::cart
