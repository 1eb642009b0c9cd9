#include "murosimf/control/robot_port.h"

#include <cmath>

namespace murosimf {

namespace {

constexpr double kTouchHeight = 5e-4;  // [m] below which a sole counts as touching
constexpr double kTouchForce = 1;      // [N] above which it does where forces are known

bool isUsable(const client::JointCommand& c) {
  const bool finite = std::isfinite(c.position) && std::isfinite(c.velocity) && std::isfinite(c.torque) &&
                      std::isfinite(c.kp) && std::isfinite(c.kd);
  return finite && c.kp >= 0 && c.kd >= 0;
}

}  // namespace

const OutsideAccess& RobotPort::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.adds(kJointCommand, subset::kJoints);
    d.reads(kJointPosition, subset::kJoints);
    d.reads(kJointVelocity, subset::kJoints);
    d.readsIfAdded(kMeasuredTorque, subset::kJoints);
    d.readsIfAdded(kSoleClearance, subset::kSoles);
    d.readsIfAdded(kSolePressure, subset::kSoles);
    d.readsIfAdded(kGyroscope);
    d.readsIfAdded(kAccelerometer);
  });
  return access;
}

RobotPort::RobotPort(LinkedWorld& linked, ObjectId robot, client::RobotDescription description)
    : robot_(robot),
      description_(std::move(description)),
      command_(linked.handle(robot, kJointCommand, subset::kJoints)),
      position_(linked.handle(robot, kJointPosition, subset::kJoints)),
      velocity_(linked.handle(robot, kJointVelocity, subset::kJoints)),
      torque_(linked.handle(robot, kMeasuredTorque, subset::kJoints)),
      clearance_(linked.handle(robot, kSoleClearance, subset::kSoles)),
      pressure_(linked.handle(robot, kSolePressure, subset::kSoles)),
      gyroscope_(linked.handle(robot, kGyroscope)),
      accelerometer_(linked.handle(robot, kAccelerometer)),
      joints_(description_.joints.size()) {}

void RobotPort::readSensors(double t, client::SensorFrame& sensors) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const int joint = static_cast<int>(i);
    joints_[i] = {position_.get(joint), velocity_.get(joint), torque_.valid() ? torque_.get(joint) : 0.0};
  }
  sensors.time = t;
  sensors.joints = joints_;
  if (gyroscope_.valid()) sensors.angular_velocity = gyroscope_.get();
  if (accelerometer_.valid()) sensors.specific_force = accelerometer_.get();
  for (int i = 0; i < 2; ++i) sensors.foot_touches[static_cast<std::size_t>(i)] = touches(i);
}

bool RobotPort::touches(int sole) const {
  if (pressure_.size() > sole) {
    const CornerForces<> corners = pressure_.get(sole);
    return corners.of[0] + corners.of[1] + corners.of[2] + corners.of[3] > kTouchForce;
  }
  return clearance_.size() > sole && clearance_.get(sole) < kTouchHeight;
}

client::CommandFrame RobotPort::emptyCommands() const {
  client::CommandFrame commands;
  commands.joints.resize(joints_.size());
  return commands;
}

int RobotPort::applyCommands(const client::CommandFrame& commands) {
  int refused = 0;
  const LaneValues<ServoCommand> values = command_.values();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (i >= commands.joints.size() || !isUsable(commands.joints[i])) {
      ++refused;
      continue;
    }
    const client::JointCommand& c = commands.joints[i];
    values.set({c.position, c.velocity, c.torque, c.kp, c.kd}, static_cast<int>(i));
  }
  return refused;
}

}  // namespace murosimf
