#include "laser_guard.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::cart {

namespace {
double squared(double x) { return x * x; }

constexpr double kStep = 15 * kPi / 180, kFarthest = kPi / 2;  // of directions that are tried
}  // namespace

void LaserGuard::see(std::span<const client::RangeScan> scans) {
  for (const client::RangeScan& scan : scans) {
    const client::RangeSensorDescription& sensor = sensors_[static_cast<std::size_t>(scan.sensor)];
    if (sensor.angles.size() < 2) continue;
    points_.clear();
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      if (!std::isfinite(scan.ranges[i])) continue;
      const SinCos<double> a = sincos(sensor.angles[i]);
      const Vector3 p = sensor.X_BS * Vector3{scan.ranges[i] * a.cos, scan.ranges[i] * a.sin, 0};
      points_.push_back({p.x, p.y});
    }
  }
}

double LaserGuard::freeWay(double direction, double most) const {
  const SinCos<double> a = sincos(direction);
  double free = most;
  for (const GroundPoint& p : points_) {
    if (forgiven_ && squared(p.x - forgiven_->x) + squared(p.y - forgiven_->y) < squared(near_)) continue;
    const double along = a.cos * p.x + a.sin * p.y, beside = a.cos * p.y - a.sin * p.x;
    if (along <= 0 || std::fabs(beside) >= radius_) continue;
    free = std::min(free, std::max(along - std::sqrt(radius_ * radius_ - beside * beside), 0.0));
  }
  return free;
}

double LaserGuard::wayAround(double direction, double way) const {
  double best = direction, most = freeWay(direction, way);
  for (double off = kStep; most < way && off <= kFarthest; off += kStep) {
    for (const double side : {off, -off}) {
      const double free = freeWay(direction + side, way);
      if (free > most + 0.02) most = free, best = direction + side;
    }
  }
  return best;
}

}  // namespace murosimf::controllers::cart
