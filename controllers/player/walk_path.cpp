#include "walk_path.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {

namespace {
constexpr double kNear = 0.45;        // from here on in any direction [m]
constexpr double kSlowing = 1.2;      // speed over distance [1/s]
constexpr double kTurning = 1.8;      // turning rate over bearing [1/s]
constexpr double kFastestTurn = 0.9;  // [rad/s]
constexpr double kSidestep = 0.08;    // [m/s]

double turningRate(double bearing) { return clamp(kTurning * bearing, -kFastestTurn, kFastestTurn); }
}  // namespace

WalkCommand turnTo(double bearing) { return {0, 0, clamp(1.5 * bearing, -0.8, 0.8)}; }

WalkCommand walkTo(const PlanarPose& target_R, double largest) {
  const Point p{target_R.x, target_R.y};
  const double distance = norm(p), bearing = direction(p);
  if (distance < kNear) {
    const double vx = clamp(kSlowing * p.x, -std::min(largest, 0.10), largest);
    const double vy = clamp(kSlowing * p.y, -std::min(largest, kSidestep), std::min(largest, kSidestep));
    return {vx, vy, turningRate(target_R.heading)};
  }
  // Ahead only as far as the robot looks there already; on a curve the side speed brings it back to the line.
  const double ahead = std::max(0.0, 1 - std::fabs(bearing) / degrees(60));
  const double speed = std::min(largest, kSlowing * distance);
  return {speed * ahead, clamp(0.5 * speed * bearing * ahead, -kSidestep, kSidestep), turningRate(bearing)};
}

Point detour(const Point& target_R, std::span<const Point> obstacles_R, double clearance, double ignored) {
  const double distance = norm(target_R);
  if (distance < 1e-6) return target_R;
  const Point along = (1 / distance) * target_R;
  const Point left{-along.y, along.x};
  double nearest = std::min(distance, 0.9);  // what is farther away may have moved when the robot gets there
  Point way = target_R;
  for (const Point& obstacle : obstacles_R) {
    const double ahead = dot(obstacle, along), beside = dot(obstacle, left);
    const bool in_way = ahead > 0 && ahead < nearest && std::fabs(beside) < clearance;
    if (!in_way || norm(obstacle - target_R) < ignored) continue;
    nearest = ahead;
    way = obstacle + (beside > 0 ? -clearance : clearance) * left;
  }
  return way;
}

Point wayAround(const Point& centre_R, double radius, const Point& target_R) {
  const double distance = norm(centre_R);
  const Point from_centre = target_R - centre_R;
  // Polar angles around the centre: the robot's is 0, the target's is `around`.
  const double robot = direction(Point{0, 0} - centre_R);
  const double around = wrapAngle(direction(from_centre) - robot);
  // A line that leaves the robot along the tangent touches the circle this far around it.
  const double tangent = distance > radius ? acos(radius / distance) : 0.0;
  const double target_tangent = norm(from_centre) > radius ? acos(radius / norm(from_centre)) : 0.0;
  if (std::fabs(around) <= tangent + target_tangent + degrees(5)) return target_R;
  // The next point stands outside the circle by this factor, so that a straight way to it need not cut the circle.
  constexpr double kOutside = 1.06;
  const double outside = kOutside * radius;
  const double step = std::min(std::fabs(around), tangent + acos(1 / kOutside));
  const SinCos<double> a = sincos(robot + (around < 0 ? -step : step));
  return centre_R + outside * Point{a.cos, a.sin};
}

}  // namespace murosimf::controllers
