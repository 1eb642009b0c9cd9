#include "murosimf/control/servo_bus/imu_board.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace murosimf::servo_bus {

namespace {

constexpr double kCounts = 32768;
constexpr double kGravity = 9.80665;  // [m/s^2]

double counted(double value, double range) {
  const double count = std::clamp(std::round(value / range * kCounts), -kCounts, kCounts - 1);
  return count * range / kCounts;
}

Vector3 counted(const Vector3& v, double range) {
  return {counted(v.x, range), counted(v.y, range), counted(v.z, range)};
}

/// Ranges double from one setting to the next: 125 deg/s, 3 g.
double gyroRange(std::int64_t setting) { return 125 * std::numbers::pi / 180 * static_cast<double>(1 << setting); }
double accelerometerRange(std::int64_t setting) { return 3 * kGravity * static_cast<double>(1 << setting); }

}  // namespace

ImuBoard::Quaternion ImuBoard::product(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

ImuBoard::Quaternion ImuBoard::unit(const Quaternion& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / size, q.x / size, q.y / size, q.z / size};
}

Vector3 ImuBoard::turned(const Quaternion& q, const Vector3& v) {
  const Quaternion r = product(product(q, {0, v.x, v.y, v.z}), {q.w, -q.x, -q.y, -q.z});
  return {r.x, r.y, r.z};
}

/// To second order in the angle of a step.
void ImuBoard::turn(const Vector3& rate, double dt) {
  const double x = 0.5 * dt * rate.x, y = 0.5 * dt * rate.y, z = 0.5 * dt * rate.z;
  q_ = unit(product(q_, {1 - 0.5 * (x * x + y * y + z * z), x, y, z}));
}

void ImuBoard::straighten(const Vector3& specific_force, double gain) {
  const Vector3 up = turned(q_, specific_force);
  const double size = std::sqrt(up.x * up.x + up.y * up.y + up.z * up.z);
  if (size < 1e-6) return;  // it falls
  const double w = std::sqrt(std::max(0.5 * (1 + up.z / size), 0.0));
  const Quaternion whole = w > 1e-6 ? Quaternion{w, 0.5 * up.y / size / w, -0.5 * up.x / size / w, 0}
                                    : Quaternion{0, 1, 0, 0};  // upside down: any way around
  q_ = unit(product(unit({1 - gain + gain * whole.w, gain * whole.x, gain * whole.y, 0}), q_));
}

void ImuBoard::sense(Device& device, const client::ImuReading& reading, double dt) {
  const Vector3 rate = counted(reading.angular_velocity, gyroRange(device.get(Item::kGyroRange)));
  const Vector3 force = counted(reading.specific_force, accelerometerRange(device.get(Item::kAccelerometerRange)));
  const double gain = device.getFloat(Item::kAccelerometerGain);
  if (started_) turn(rate, dt);
  straighten(force, started_ ? (gain >= 0 && gain <= 1 ? gain : 0) : 1);
  started_ = true;
  device.setFloat(Item::kGyroX, rate.x), device.setFloat(Item::kGyroY, rate.y), device.setFloat(Item::kGyroZ, rate.z);
  device.setFloat(Item::kAccelerometerX, force.x), device.setFloat(Item::kAccelerometerY, force.y);
  device.setFloat(Item::kAccelerometerZ, force.z);
  device.setFloat(Item::kOrientationX, q_.x), device.setFloat(Item::kOrientationY, q_.y);
  device.setFloat(Item::kOrientationZ, q_.z), device.setFloat(Item::kOrientationW, q_.w);
}

}  // namespace murosimf::servo_bus
