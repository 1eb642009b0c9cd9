#include "attitude.h"

#include <cmath>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::trotter {

namespace {
constexpr double kGravity = 9.81, kMostExcess = 0.5;  // [m/s^2], of g
constexpr double kShare = 0.5;                        // [1/s]
}  // namespace

void Attitude::observe(double dt, const Vector3& angular_velocity, const Vector3& specific_force) {
  up_ = up_ + cross(up_, angular_velocity) * dt;
  const double size = norm(specific_force);
  if (std::fabs(size - kGravity) < kMostExcess * kGravity)
    up_ = up_ + (specific_force * (1 / size) - up_) * (kShare * dt);
  up_ = up_ * (1 / norm(up_));
}

double Attitude::roll() const { return atan2(up_.y, up_.z); }
double Attitude::pitch() const { return atan2(-up_.x, sqrt(up_.y * up_.y + up_.z * up_.z)); }

}  // namespace murosimf::controllers::trotter
