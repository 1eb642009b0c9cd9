#include "murosimf/control/servo_bus/profile.h"

#include <algorithm>
#include <cmath>

namespace murosimf::servo_bus {

namespace {

constexpr double kLongestStep = 1e-3;  // [s]

}  // namespace

void Profile::advance(double goal, double largest_velocity, double acceleration, double dt) {
  if (largest_velocity <= 0) {
    position = goal, velocity = 0;
    return;
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  const double h = dt / steps;
  for (int i = 0; i < steps; ++i) {
    const double left = goal - position, way = std::abs(left);
    double speed = std::min(largest_velocity, way / h);
    if (acceleration > 0) {
      const double change = acceleration * h;  // it slows down by whole steps: sqrt(2 a d) less half of one
      const double brake = std::sqrt(2 * acceleration * way + 0.25 * change * change) - 0.5 * change;
      speed = std::min(speed, brake);
      velocity += std::clamp(std::copysign(speed, left) - velocity, -change, change);
    } else {
      velocity = std::copysign(speed, left);
    }
    position += velocity * h;
    if (std::abs(goal - position) < 1e-9) position = goal;
    if (position == goal && std::abs(velocity) <= acceleration * h + 1e-12) velocity = 0;
  }
  if (position == goal && acceleration <= 0) velocity = 0;
}

void Profile::turn(double wanted_velocity, double acceleration, double dt) {
  const double change = acceleration > 0 ? acceleration * dt : std::abs(wanted_velocity - velocity);
  velocity += std::clamp(wanted_velocity - velocity, -change, change);
}

}  // namespace murosimf::servo_bus
