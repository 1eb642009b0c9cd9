#include "murosimf/control/player_api/motor_table.h"

#include <algorithm>
#include <cmath>

namespace murosimf::player_api {

namespace {

constexpr double kFullTorqueError = 0.1;  // angle at which a motor without told gains gives all it has [rad]
constexpr double kTurningGain = 10;       // torque over largest torque, over velocity error over largest velocity

double clampIfLimited(double value, double lower, double upper) {
  return upper > lower ? std::clamp(value, lower, upper) : value;
}

}  // namespace

MotorTable::MotorTable(const std::vector<client::JointDescription>& joints) : joints_(joints), motors_(joints.size()) {
  for (std::size_t i = 0; i < joints_.size(); ++i)
    motors_[i].kp = joints_[i].largest_torque > 0 ? joints_[i].largest_torque / kFullTorqueError : 1;
}

bool MotorTable::askPosition(int joint, double position) {
  if (std::isnan(position)) return false;
  const auto i = static_cast<std::size_t>(joint);
  Motor& motor = motors_[i];
  motor.mode = std::isinf(position) ? Mode::kTurn : Mode::kPosition;
  if (std::isfinite(position)) motor.position = clampIfLimited(position, joints_[i].lower, joints_[i].upper);
  return true;
}

bool MotorTable::askVelocity(int joint, double velocity) {
  if (!std::isfinite(velocity)) return false;
  const auto i = static_cast<std::size_t>(joint);
  const double largest = joints_[i].largest_velocity;
  motors_[i].velocity = clampIfLimited(velocity, -largest, largest);
  motors_[i].limited = true;
  motors_[i].kept_known = motors_[i].kept_known && motors_[i].holds;
  motors_[i].holds = velocity == 0;
  return true;
}

bool MotorTable::askTorque(int joint, double torque) {
  if (!std::isfinite(torque)) return false;
  const auto i = static_cast<std::size_t>(joint);
  const double largest = joints_[i].largest_torque;
  motors_[i].torque = clampIfLimited(torque, -largest, largest);
  motors_[i].mode = Mode::kPush;
  return true;
}

bool MotorTable::askGains(int joint, double kp, double kd) {
  if (!std::isfinite(kp) || !std::isfinite(kd) || kp < 0 || kd < 0) return false;
  Motor& motor = motors_[static_cast<std::size_t>(joint)];
  motor.kp = kp, motor.kd = kd;
  return true;
}

bool MotorTable::askCommand(int joint, const client::JointCommand& c) {
  const bool finite = std::isfinite(c.position) && std::isfinite(c.velocity) && std::isfinite(c.torque) &&
                      std::isfinite(c.kp) && std::isfinite(c.kd);
  if (!finite || c.kp < 0 || c.kd < 0) return false;
  Motor& motor = motors_[static_cast<std::size_t>(joint)];
  motor.mode = Mode::kCommand;
  motor.command = c;
  return true;
}

client::JointCommand MotorTable::commandOf(const Motor& motor, const client::JointDescription& joint) const {
  switch (motor.mode) {
    case Mode::kCommand:
      return motor.command;
    case Mode::kPush:
      return {motor.kept, 0, motor.torque, 0, 0};
    case Mode::kTurn: {
      const double gain = joint.largest_velocity > 0 ? kTurningGain * joint.largest_torque / joint.largest_velocity : 1;
      return {motor.kept, motor.velocity, 0, 0, gain};
    }
    case Mode::kPosition:
      if (motor.limited && motor.velocity == 0) return {motor.kept, 0, 0, motor.kp, motor.kd};
      return {motor.position, motor.limited ? std::abs(motor.velocity) : 0, 0, motor.kp, motor.kd};
    case Mode::kNone:
      break;
  }
  return {motor.kept, 0, 0, motor.kp, motor.kd};
}

void MotorTable::fill(std::span<const client::JointReading> joints, bool limp,
                      std::vector<client::JointCommand>& commands) {
  commands.resize(motors_.size());
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    Motor& motor = motors_[i];
    const bool follows = motor.mode == Mode::kPush || motor.mode == Mode::kTurn;
    if ((!motor.kept_known || follows) && i < joints.size()) motor.kept = joints[i].position, motor.kept_known = true;
    commands[i] = commandOf(motor, joints_[i]);
    if (limp) commands[i] = {commands[i].position, 0, 0, 0, 0};
  }
}

void MotorTable::archive(StateArchive& archive) {
  for (Motor& m : motors_) {
    archive(m.mode, m.position, m.velocity, m.torque, m.limited, m.holds, m.kp, m.kd, m.command, m.kept, m.kept_known);
  }
}

}  // namespace murosimf::player_api
