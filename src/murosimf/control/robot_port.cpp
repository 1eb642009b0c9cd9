#include "murosimf/control/robot_port.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

constexpr double kTouchHeight = 5e-4;  // [m] below which a sole counts as touching
constexpr double kFootForce = 1;       // [N] above which it does where forces are known

bool isUsable(const client::JointCommand& c) {
  const bool finite = std::isfinite(c.position) && std::isfinite(c.velocity) && std::isfinite(c.torque) &&
                      std::isfinite(c.kp) && std::isfinite(c.kd);
  return finite && c.kp >= 0 && c.kd >= 0;
}

template <class T>
Sensed<T> sensed(LinkedWorld& linked, ObjectId robot, const Variable<T>& truth, const Variable<T>& reading,
                 std::string_view of) {
  return {linked.handle(robot, truth, of), linked.handle(robot, reading, of)};
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
    d.readsIfAdded(kGyroscope, subset::kImus);
    d.readsIfAdded(kAccelerometer, subset::kImus);
    d.readsIfAdded(kJointPositionReading, subset::kJoints);
    d.readsIfAdded(kJointVelocityReading, subset::kJoints);
    d.readsIfAdded(kMeasuredTorqueReading, subset::kJoints);
    d.readsIfAdded(kSolePressureReading, subset::kSoles);
    d.readsIfAdded(kGyroscopeReading, subset::kImus);
    d.readsIfAdded(kAccelerometerReading, subset::kImus);
    d.readsIfAdded(kTouch, subset::kTouchSensors);
    d.readsIfAdded(kTouchReading, subset::kTouchSensors);
    d.readsIfAdded(kSensedForce, subset::kForceSensors);
    d.readsIfAdded(kSensedForceReading, subset::kForceSensors);
  });
  return access;
}

RobotPort::RobotPort(LinkedWorld& linked, ObjectId robot, client::RobotDescription description)
    : robot_(robot),
      description_(std::move(description)),
      command_(linked.handle(robot, kJointCommand, subset::kJoints)),
      clearance_(linked.handle(robot, kSoleClearance, subset::kSoles)),
      position_(sensed(linked, robot, kJointPosition, kJointPositionReading, subset::kJoints)),
      velocity_(sensed(linked, robot, kJointVelocity, kJointVelocityReading, subset::kJoints)),
      torque_(sensed(linked, robot, kMeasuredTorque, kMeasuredTorqueReading, subset::kJoints)),
      pressure_(sensed(linked, robot, kSolePressure, kSolePressureReading, subset::kSoles)),
      gyroscope_(sensed(linked, robot, kGyroscope, kGyroscopeReading, subset::kImus)),
      accelerometer_(sensed(linked, robot, kAccelerometer, kAccelerometerReading, subset::kImus)),
      touch_(sensed(linked, robot, kTouch, kTouchReading, subset::kTouchSensors)),
      force_(sensed(linked, robot, kSensedForce, kSensedForceReading, subset::kForceSensors)),
      joints_(description_.joints.size()),
      imus_(description_.imus.size()),
      sole_touches_(description_.soles.size()),
      sole_pressures_(description_.soles.size()),
      touches_(description_.touch_sensors.size()),
      forces_(description_.force_sensors.size()) {}

void RobotPort::readSensors(double t, client::SensorFrame& sensors) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const int joint = static_cast<int>(i);
    joints_[i] = {position_.get(joint), velocity_.get(joint), torque_.valid() ? torque_.get(joint) : 0.0};
  }
  sensors.time = t;
  sensors.joints = joints_;
  readImus(sensors);
  for (std::size_t i = 0; i < sole_touches_.size(); ++i) {
    sole_touches_[i] = touches(static_cast<int>(i)) ? 1 : 0;
    sole_pressures_[i] = pressureOf(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const int sensor = static_cast<int>(i);
    touches_[i] = touch_.size() > sensor && touch_.get(sensor) > 0.5 ? 1 : 0;
  }
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const int sensor = static_cast<int>(i);
    forces_[i] = force_.size() > sensor ? force_.get(sensor) : Vector3{};
  }
  sensors.sole_touches = sole_touches_;
  sensors.sole_pressures = sole_pressures_;
  sensors.touches = touches_;
  sensors.forces = forces_;
}

void RobotPort::readImus(client::SensorFrame& sensors) {
  for (std::size_t i = 0; i < imus_.size(); ++i) {
    const int imu = static_cast<int>(i);
    if (gyroscope_.size() > imu) imus_[i].angular_velocity = gyroscope_.get(imu);
    if (accelerometer_.size() > imu) imus_[i].specific_force = accelerometer_.get(imu);
  }
  sensors.imus = imus_;
  if (gyroscope_.size() > 0) sensors.angular_velocity = gyroscope_.get();
  if (accelerometer_.size() > 0) sensors.specific_force = accelerometer_.get();
}

std::array<double, 4> RobotPort::pressureOf(int sole) const {
  std::array<double, 4> corners{};
  if (pressure_.size() > sole) std::copy_n(pressure_.get(sole).of, 4, corners.begin());
  return corners;
}

bool RobotPort::touches(int sole) const {
  if (pressure_.size() > sole) {
    const CornerForces<> corners = pressure_.get(sole);
    return corners.of[0] + corners.of[1] + corners.of[2] + corners.of[3] > kFootForce;
  }
  return clearance_.size() > sole && clearance_.get(sole) < kTouchHeight;
}

client::CommandFrame RobotPort::emptyCommands() const {
  client::CommandFrame commands;
  commands.joints.resize(joints_.size());
  commands.camera_periods.resize(description_.cameras.size(), client::kCameraAsIs);
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
