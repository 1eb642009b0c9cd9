#include "wheel_drive.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::cart {

namespace {
constexpr double kDamping = 0.05;  // [N m s/rad]: a rate is asked for, no position
}

WheelDrive::WheelDrive(const client::RobotDescription& robot) {
  for (const client::WheelDescription& wheel : robot.wheels) {
    if (wheel.joint < 0) continue;
    addWheel(wheel, robot.joints[static_cast<std::size_t>(wheel.joint)].largest_velocity);
  }
  if (wheels_.empty() || !invert())
    throw std::invalid_argument("cart: the " + std::to_string(wheels_.size()) + " driven wheels of '" + robot.model +
                                "' cannot drive and turn it, expected two with tyres or three with rollers");
}

void WheelDrive::addWheel(const client::WheelDescription& wheel, double fastest) {
  const double length = std::sqrt(wheel.axle.x * wheel.axle.x + wheel.axle.y * wheel.axle.y);
  const double dx = wheel.axle.y / length, dy = -wheel.axle.x / length;
  const SinCos<double> a = sincos(wheel.rollers ? wheel.roller_angle : 0.0);
  const double gx = a.cos * dx - a.sin * dy, gy = a.sin * dx + a.cos * dy;
  addGrip(wheel, gx, gy, wheel.radius * (gx * dx + gy * dy));
  wheels_.push_back({static_cast<std::size_t>(wheel.joint), fastest, grips_.back()});
  if (wheel.rollers) return;
  omnidirectional_ = false;
  addGrip(wheel, -dy, dx, 0);
}

void WheelDrive::addGrip(const client::WheelDescription& wheel, double gx, double gy, double per_turn) {
  grips_.push_back({gx, gy, wheel.centre.x * gy - wheel.centre.y * gx, per_turn, static_cast<int>(wheels_.size())});
  if (per_turn == 0) grips_.back().wheel = -1;
}

/// Inverts the sum of g g^T. @return false where some motion of the base turns no wheel
bool WheelDrive::invert() {
  double m[3][3] = {};
  for (const Grip& g : grips_) {
    const double row[3] = {g.gx, g.gy, g.arm};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m[i][j] += row[i] * row[j];
    }
  }
  const auto minor = [&](int i, int j) {
    const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[r][c] * m[s][d] - m[r][d] * m[s][c];
  };
  const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  if (!(std::fabs(det) > 1e-9)) return false;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inverse_[i][j] = minor(j, i) / det;
  }
  return true;
}

void WheelDrive::command(const BaseMotion& velocity, std::span<client::JointCommand> joints) const {
  const auto rateOf = [&](const Wheel& w) {
    return (w.drive.gx * velocity.x + w.drive.gy * velocity.y + w.drive.arm * velocity.turn) / w.drive.per_turn;
  };
  double scale = 1;
  for (const Wheel& wheel : wheels_) {
    const double rate = std::fabs(rateOf(wheel));
    if (rate > wheel.fastest) scale = std::min(scale, wheel.fastest / rate);
  }
  for (const Wheel& wheel : wheels_) joints[wheel.joint] = {0, scale * rateOf(wheel), 0, 0, kDamping};
}

BaseMotion WheelDrive::wayOf(std::span<const client::JointReading> joints, std::vector<double>& last) const {
  double sum[3] = {0, 0, 0};
  for (const Grip& g : grips_) {
    if (g.wheel < 0) continue;
    const auto number = static_cast<std::size_t>(g.wheel);
    const double rolled = (joints[wheels_[number].joint].position - last[number]) * g.per_turn;
    sum[0] += g.gx * rolled, sum[1] += g.gy * rolled, sum[2] += g.arm * rolled;
  }
  for (std::size_t i = 0; i < wheels_.size(); ++i) last[i] = joints[wheels_[i].joint].position;
  const auto entry = [&](int i) { return inverse_[i][0] * sum[0] + inverse_[i][1] * sum[1] + inverse_[i][2] * sum[2]; };
  return {entry(0), entry(1), entry(2)};
}

}  // namespace murosimf::controllers::cart
