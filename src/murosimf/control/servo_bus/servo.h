#pragma once

/// @file A device on the bus that drives a joint.
///
/// sense() writes what a servo would measure into its registers, command() turns its registers into a joint command:
/// torque off     nothing: the joint is limp
/// position       the goal on the way of its profile, kp and kd of servo_units.h. Goal PWM, Goal Current (mode 5) and
///                Torque Limit bound the error that is sent by tau_most/kp, once a control period.
/// velocity       commanded gains: kd = (velocity P gain/128) T/(885 unit) on the velocity, the gain of 1.0 taken as
/// 100,
///                as its I gain makes up for the induced voltage; the robot file's: a
///                goal that lies ahead, at that speed, so that every level of detail can follow
/// current        the torque i T/I;   PWM: T (u - w/w0)
/// The angle of the servo is direction (q - zero). Its register counts turns where the mode knows them, from the turn
/// it was in when it was switched on.

#include "murosimf/control/client/robot_frames.h"
#include "murosimf/control/servo_bus/device.h"
#include "murosimf/control/servo_bus/profile.h"
#include "murosimf/control/servo_bus/servo_settings.h"
#include "murosimf/control/servo_bus/servo_units.h"

namespace murosimf::servo_bus {

class Servo {
 public:
  Servo(const ServoSettings& servo, const ServoBusSettings& bus, const ControlTable& table);

  /// What the joint does at time t, dt after the last call.
  void sense(Device& device, const client::JointReading& joint, double t, double dt);
  /// What it is to do in the next dt.
  client::JointCommand command(Device& device, double dt);
  void archive(StateArchive& archive);

 private:
  void takeUp(Device& device);
  void watch(Device& device, double dt);
  void tellMotion(Device& device) const;
  void tellEffort(Device& device) const;
  bool reversed(const Device& device) const;
  std::int64_t offset(const Device& device) const;
  std::int64_t registerOf(const Device& device, double angle) const;
  double angleOfRegister(const Device& device, std::int64_t value) const;
  void chooseLimits(const Device& device, double goal);
  double largestTorque(const Device& device) const;
  client::JointCommand hold(Device& device, double dt);
  client::JointCommand roll(Device& device, double dt);
  client::JointCommand push(const Device& device) const;
  client::JointCommand outward(client::JointCommand command) const;

  ServoSettings settings_;
  ServoScale scale_;
  Gains gains_;
  double supply_voltage_, temperature_, overload_time_;
  bool torque_on_;
  // What follows is state; angles and torques are the servo's own.
  double angle_ = 0, velocity_ = 0, torque_ = 0;
  Profile profile_;
  double goal_ = 0, speed_limit_ = 0, acceleration_ = 0;  ///< of the profile under way
  double loaded_ = 0, silent_ = 0;                        ///< for so long [s]
  std::int64_t turn_ = 0;                                 ///< steps of the turn that counts as the first
  std::uint32_t restarts_ = 0;
  std::uint32_t goal_writes_ = 0;  ///< at the last restart
  bool was_on_ = false, sensed_ = false;
};

}  // namespace murosimf::servo_bus
