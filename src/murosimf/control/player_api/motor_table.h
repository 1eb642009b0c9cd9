#pragma once

/// @file What a client has asked of each motor, and the joint commands that this makes.
///
/// A motor is, after the last thing asked of it,
///   positioned   towards `position`, no faster than `velocity` where one was told (0: it stays where it is)
///   turning      with `velocity`: after a position of plus or minus infinity
///   pushing      with a force or torque, until it gets a position again
/// A motor that was never asked for anything keeps the angle that it had at the first step.
/// Gains are the joint's in SI units, N m/rad and N m s/rad. Until a client tells them kp = torque / 0.1 rad, and
/// kd = 0; a turning motor has kd = 10 torque / velocity, with the largest torque and velocity of the joint.

#include <span>
#include <vector>

#include "murosimf/control/client/robot_description.h"
#include "murosimf/control/client/robot_frames.h"
#include "murosimf/math/state_archive.h"

namespace murosimf::player_api {

class MotorTable {
 public:
  explicit MotorTable(const std::vector<client::JointDescription>& joints);

  /// Each returns false where the number makes no sense (not a number; for all but a position also not finite; gains
  /// below zero) and then changes nothing. What is beyond the joint's limits is taken as the limit.
  bool askPosition(int joint, double position);
  bool askVelocity(int joint, double velocity);
  bool askTorque(int joint, double torque);
  bool askGains(int joint, double kp, double kd);
  /// Everything at once, as it is. False where a number is not finite, or a gain below zero.
  bool askCommand(int joint, const client::JointCommand& command);

  /// @param limp  motors neither hold nor push; what was asked of them is kept for later
  void fill(std::span<const client::JointReading> joints, bool limp, std::vector<client::JointCommand>& commands);
  void archive(StateArchive& archive);

 private:
  enum class Mode { kNone, kPosition, kTurn, kPush, kCommand };
  struct Motor {
    Mode mode = Mode::kNone;
    double position = 0, velocity = 0, torque = 0;  // asked for
    bool limited = false, holds = false;            // velocity was told; it holds what it had when told 0
    double kp = 0, kd = 0;
    client::JointCommand command;  // of mode kCommand
    double kept = 0;               // angle that it holds
    bool kept_known = false;
  };
  client::JointCommand commandOf(const Motor& motor, const client::JointDescription& joint) const;

  std::vector<client::JointDescription> joints_;
  std::vector<Motor> motors_;
};

}  // namespace murosimf::player_api
