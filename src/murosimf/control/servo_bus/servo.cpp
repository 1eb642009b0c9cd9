#include "murosimf/control/servo_bus/servo.h"

#include <algorithm>
#include <cmath>

namespace murosimf::servo_bus {

namespace {

constexpr std::int64_t kReversedBit = 0x01, kTimeBased = 0x04;  // of Drive Mode
constexpr double kOverloadShare = 0.95;
constexpr double kWatchdogUnit = 0.02;  // [s]
constexpr double kLookAhead = 1;        // [s] by which the goal of a turning servo is ahead

bool isTurning(OperatingMode mode) { return mode == OperatingMode::kVelocity; }
bool isPushing(OperatingMode mode) { return mode == OperatingMode::kCurrent || mode == OperatingMode::kPwm; }

}  // namespace

Servo::Servo(const ServoSettings& servo, const ServoBusSettings& bus, const ControlTable& table)
    : settings_(servo),
      scale_(scaleOf(table, bus.supply_voltage)),
      gains_(bus.gains),
      supply_voltage_(bus.supply_voltage),
      temperature_(bus.temperature),
      overload_time_(bus.overload_time),
      torque_on_(bus.torque_on) {}

bool Servo::reversed(const Device& device) const { return (device.get(Item::kDriveMode) & kReversedBit) != 0; }

/// What is added to the steps of an angle.
std::int64_t Servo::offset(const Device& device) const {
  if (!scale_.old) return device.get(Item::kHomingOffset) - turn_;
  return device.mode() == OperatingMode::kExtendedPosition ? device.get(Item::kMultiTurnOffset) - turn_ : 0;
}

std::int64_t Servo::registerOf(const Device& device, double angle) const {
  const std::int64_t steps = stepsOf(reversed(device) ? -angle : angle) + static_cast<std::int64_t>(kMiddle);
  return steps + offset(device);
}

double Servo::angleOfRegister(const Device& device, std::int64_t value) const {
  const double angle = angleOf(static_cast<double>(value - offset(device)) - kMiddle);
  return reversed(device) ? -angle : angle;
}

void Servo::takeUp(Device& device) {
  restarts_ = device.restarts();
  goal_writes_ = device.goalWrites();
  const std::int64_t steps = stepsOf(reversed(device) ? -angle_ : angle_) + static_cast<std::int64_t>(kMiddle);
  constexpr auto kTurn = static_cast<std::int64_t>(kStepsPerTurn);
  turn_ = steps - ((steps % kTurn + kTurn) % kTurn);
  profile_ = {angle_, 0};
  goal_ = angle_;
  loaded_ = silent_ = 0;
  device.set(Item::kGoalPosition, registerOf(device, angle_));
}

void Servo::sense(Device& device, const client::JointReading& joint, double t, double dt) {
  angle_ = settings_.direction * (joint.position - settings_.zero);
  velocity_ = settings_.direction * joint.velocity;
  torque_ = settings_.direction * joint.torque;
  if (!sensed_ && torque_on_) device.set(Item::kTorqueEnable, 1);
  if (!sensed_ || restarts_ != device.restarts()) takeUp(device);
  sensed_ = true;
  device.set(Item::kRealtimeTick, std::llround(t * 1000) % 32768);
  device.set(Item::kPresentVoltage, std::llround(10 * supply_voltage_));
  device.set(Item::kPresentTemperature, std::llround(temperature_));
  tellMotion(device);
  tellEffort(device);
  watch(device, dt);
}

void Servo::tellMotion(Device& device) const {
  std::int64_t position = registerOf(device, angle_);
  if (scale_.old && device.mode() != OperatingMode::kExtendedPosition) position &= 4095;
  const double sign = reversed(device) ? -1 : 1;
  device.set(Item::kPresentPosition, position);
  device.set(Item::kPresentVelocity, velocityRegister(scale_, sign * velocity_));
  device.set(Item::kVelocityTrajectory, velocityRegister(scale_, sign * profile_.velocity));
  device.set(Item::kPositionTrajectory, registerOf(device, profile_.position));
  const bool holds = device.torqueEnabled() && !isTurning(device.mode()) && !isPushing(device.mode());
  const double near = angleOf(20), left = std::abs(goal_ - angle_);
  const bool under_way = holds && profile_.position != goal_;
  const double threshold = scale_.velocity_unit * static_cast<double>(device.get(Item::kMovingThreshold));
  device.set(Item::kMoving, scale_.old ? under_way || (holds && left > near) : std::abs(velocity_) > threshold);
  const int type = speed_limit_ <= 0 ? 0 : acceleration_ <= 0 ? 0x10 : 0x30;
  const bool lags = holds && std::abs(profile_.position - angle_) > near;
  device.set(Item::kMovingStatus, holds ? type | (under_way ? 2 : 0) | (left <= near ? 1 : 0) | (lags ? 8 : 0) : 0);
}

void Servo::tellEffort(Device& device) const {
  const double sign = reversed(device) ? -1 : 1;
  const double share = sign * torque_ / scale_.stall_torque;
  const double duty = std::clamp(share + sign * velocity_ / scale_.no_load_speed, -1.0, 1.0);
  const double thousandths = std::clamp(1000 * share, -1000.0, 1000.0);
  device.set(Item::kPresentLoad, scale_.old ? withSignBit(thousandths) : std::llround(thousandths));
  device.set(Item::kPresentPwm, device.torqueEnabled() ? std::llround(duty * kLargestPwm) : 0);
  if (scale_.current_unit <= 0) return;
  const std::int64_t current = std::llround(sign * torque_ / scale_.torque_constant / scale_.current_unit);
  device.set(Item::kPresentCurrent, scale_.old ? std::clamp<std::int64_t>(2048 + current, 0, 4095) : current);
}

/// What makes a servo switch itself off.
void Servo::watch(Device& device, double dt) {
  loaded_ = std::abs(torque_) >= kOverloadShare * scale_.stall_torque ? loaded_ + dt : 0;
  std::int64_t alarms = device.alarms();
  const double least = 0.1 * static_cast<double>(device.get(Item::kLeastVoltage));
  const double most = 0.1 * static_cast<double>(device.get(Item::kLargestVoltage));
  if (supply_voltage_ < least || supply_voltage_ > most) alarms |= kVoltageError;
  if (temperature_ > static_cast<double>(device.get(Item::kTemperatureLimit))) alarms |= kOverheating;
  if (overload_time_ > 0 && loaded_ >= overload_time_) alarms |= kOverload;
  device.setAlarms(alarms);
  if ((alarms & device.get(Item::kShutdown)) != 0) device.set(Item::kTorqueEnable, 0);
  silent_ = device.takeHeard() || !device.torqueEnabled() ? 0 : silent_ + dt;
  const std::int64_t patience = device.get(Item::kBusWatchdog);
  if (patience > 0 && silent_ > kWatchdogUnit * static_cast<double>(patience)) {
    device.set(Item::kBusWatchdog, -1);
    device.set(Item::kGoalPosition, device.get(Item::kPresentPosition));
    for (const Item goal : {Item::kGoalVelocity, Item::kGoalCurrent, Item::kGoalPwm}) device.set(goal, 0);
    for (const Item limit : {Item::kProfileVelocity, Item::kProfileAcceleration}) device.set(limit, 0);
    if (!isPushing(device.mode())) device.set(Item::kGoalPwm, device.get(Item::kPwmLimit));
  }
}

client::JointCommand Servo::command(Device& device, double dt) {
  const bool on = device.torqueEnabled();
  if (!on || !was_on_) profile_ = {angle_, on ? velocity_ : 0};
  if (on && !was_on_) goal_ = angle_;
  was_on_ = on;
  if (!on) {
    if (scale_.old && device.goalWrites() == goal_writes_) device.set(Item::kGoalPosition, registerOf(device, angle_));
    return {};
  }
  if (isTurning(device.mode())) return outward(roll(device, dt));
  return outward(isPushing(device.mode()) ? push(device) : hold(device, dt));
}

/// The joint's command, of what was worked out for the servo.
client::JointCommand Servo::outward(client::JointCommand command) const {
  command.position = settings_.zero + settings_.direction * command.position;
  if (gains_ == Gains::kCommanded) command.velocity *= settings_.direction;
  command.torque *= settings_.direction;
  return command;
}

/// Speed and acceleration of the way to a goal; a time-based profile is told by how long it takes.
void Servo::chooseLimits(const Device& device, double goal) {
  const std::int64_t velocity = device.get(Item::kProfileVelocity);
  if (scale_.old) {
    speed_limit_ = scale_.velocity_unit * static_cast<double>(velocity & 1023);
    acceleration_ = accelerationOf(scale_, device.get(Item::kGoalAcceleration));
    return;
  }
  const std::int64_t acceleration = device.get(Item::kProfileAcceleration);
  if ((device.get(Item::kDriveMode) & kTimeBased) == 0) {
    speed_limit_ = scale_.velocity_unit * static_cast<double>(velocity);
    acceleration_ = accelerationOf(scale_, acceleration);
    return;
  }
  if (goal == goal_) return;
  const double time = 1e-3 * static_cast<double>(velocity);
  const double rise = std::min(1e-3 * static_cast<double>(acceleration), 0.5 * time);
  speed_limit_ = time > 0 ? std::abs(goal - profile_.position) / (time - rise) : 0;
  acceleration_ = rise > 0 ? speed_limit_ / rise : 0;
}

/// What the limits of its registers leave of the stall torque.
double Servo::largestTorque(const Device& device) const {
  if (scale_.old) return scale_.stall_torque * static_cast<double>(device.get(Item::kTorqueLimit)) / 1023;
  double most = scale_.stall_torque * std::abs(static_cast<double>(device.get(Item::kGoalPwm))) / kLargestPwm;
  if (device.mode() == OperatingMode::kCurrentPosition) {
    const double current = scale_.current_unit * std::abs(static_cast<double>(device.get(Item::kGoalCurrent)));
    most = std::min(most, current * scale_.torque_constant);
  }
  return most;
}

client::JointCommand Servo::hold(Device& device, double dt) {
  const double goal = angleOfRegister(device, device.get(Item::kGoalPosition));
  chooseLimits(device, goal);
  goal_ = goal;
  if (speed_limit_ > 0 && acceleration_ <= 0 && profile_.position == goal_) profile_.velocity = 0;
  profile_.advance(goal_, speed_limit_, acceleration_, dt);
  client::JointCommand command;
  command.kp = stiffnessOf(scale_, static_cast<double>(device.get(Item::kPositionP)));
  const double damping = dampingOf(scale_, static_cast<double>(device.get(Item::kPositionD)));
  const double induced = inducedDamping(scale_);
  command.kd = damping + induced;
  command.position = profile_.position;
  const double most = largestTorque(device);
  if (most < scale_.stall_torque && command.kp > 0) {
    const double reach = most / command.kp;
    command.position = std::clamp(command.position, angle_ - reach, angle_ + reach);
  }
  if (gains_ == Gains::kServo) {
    command.velocity = std::max(speed_limit_, 0.0);
  } else {
    command.velocity = profile_.velocity;
    command.torque = -induced * profile_.velocity;  // the voltage is induced by the joint's speed, not by the error's
  }
  return command;
}

client::JointCommand Servo::roll(Device& device, double dt) {
  const std::int64_t goal = device.get(scale_.old ? Item::kProfileVelocity : Item::kGoalVelocity);
  const double sign = reversed(device) ? -1 : 1;
  const double wanted = sign * scale_.velocity_unit * (scale_.old ? fromSignBit(goal) : static_cast<double>(goal));
  const Item rise = scale_.old ? Item::kGoalAcceleration : Item::kProfileAcceleration;
  profile_.turn(wanted, accelerationOf(scale_, device.get(rise)), dt);
  client::JointCommand command;
  if (gains_ == Gains::kCommanded) {
    const double p = scale_.old ? 100 : static_cast<double>(device.get(Item::kVelocityP));
    command.kd = scale_.stall_torque * p / 128 / (kLargestPwm * scale_.velocity_unit);
    command.velocity = profile_.velocity;
    return command;
  }
  if (profile_.velocity != 0) profile_.position = angle_;  // where it will stop
  command.kp = stiffnessOf(scale_, static_cast<double>(device.get(Item::kPositionP)));
  command.kd = inducedDamping(scale_);
  command.position = profile_.position + kLookAhead * profile_.velocity;
  command.velocity = std::abs(profile_.velocity);
  return command;
}

client::JointCommand Servo::push(const Device& device) const {
  const double sign = reversed(device) ? -1 : 1;
  client::JointCommand command;
  command.position = angle_;
  if (device.mode() == OperatingMode::kPwm) {
    const double share = sign * static_cast<double>(device.get(Item::kGoalPwm)) / kLargestPwm;
    command.torque = scale_.stall_torque * share;
    if (gains_ == Gains::kCommanded) {
      command.kd = inducedDamping(scale_);
    } else {
      command.torque -= inducedDamping(scale_) * velocity_;
    }
    return command;
  }
  const std::int64_t goal = device.get(scale_.old ? Item::kGoalTorque : Item::kGoalCurrent);
  const double units = scale_.old ? fromSignBit(goal) : static_cast<double>(goal);
  command.torque = sign * units * scale_.current_unit * scale_.torque_constant;
  const double most = scale_.old ? largestTorque(device) : scale_.stall_torque;
  command.torque = std::clamp(command.torque, -most, most);
  return command;
}

void Servo::archive(StateArchive& archive) {
  archive(angle_, velocity_, torque_, profile_, goal_, speed_limit_, acceleration_, loaded_, silent_, turn_, restarts_,
          goal_writes_, was_on_, sensed_);
}

}  // namespace murosimf::servo_bus
