#pragma once

/// @file Poses and points in the ground plane. F: the field in the team's own frame, R: the robot's ground frame.

#include "murosimf/math/transform.h"

namespace murosimf::controllers {

struct Point {
  double x = 0, y = 0;  ///< [m]
};

inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, const Point& a) { return {s * a.x, s * a.y}; }
inline double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline double norm(const Point& a) { return sqrt(dot(a, a)); }
/// The direction from the origin to a, against the x axis [rad].
inline double direction(const Point& a) { return atan2(a.y, a.x); }

/// v turned to the left by an angle whose sine and cosine are given.
inline Point turned(const SinCos<double>& angle, const Point& v) {
  return {fnma(angle.sin, v.y, angle.cos * v.x), fma(angle.cos, v.y, angle.sin * v.x)};
}
/// v turned to the right by it.
inline Point turnedBack(const SinCos<double>& angle, const Point& v) {
  return {fma(angle.sin, v.y, angle.cos * v.x), fnma(angle.sin, v.x, angle.cos * v.y)};
}

/// p_A of the point p_B.
inline Point transformed(const PlanarPose& X_AB, const Point& p_B) {
  return Point{X_AB.x, X_AB.y} + turned(sincos(X_AB.heading), p_B);
}
/// p_B of the point p_A.
inline Point transformedBack(const PlanarPose& X_AB, const Point& p_A) {
  return turnedBack(sincos(X_AB.heading), p_A - Point{X_AB.x, X_AB.y});
}
/// X_AC, heading in [-pi, pi].
inline PlanarPose compose(const PlanarPose& X_AB, const PlanarPose& X_BC) {
  const Point p = transformed(X_AB, {X_BC.x, X_BC.y});
  return {p.x, p.y, wrapAngle(X_AB.heading + X_BC.heading)};
}

}  // namespace murosimf::controllers
