#include "murosimf/algorithms/slope_rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace murosimf {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNearest = 1e-4;  ///< what is nearer to the camera's plane is cut off [m]

struct Range {
  double low = kInfinity, high = -kInfinity;
  void include(double x) { low = std::min(low, x), high = std::max(high, x); }
  void include(const Range& r) { low = std::min(low, r.low), high = std::max(high, r.high); }
};

/// What rounding may not leave.
SlopeRectangle widened(const Range& x, const Range& y) {
  if (x.low > x.high) return {1.0F, -1.0F, 1.0F, -1.0F};
  const double dx = 1e-3 * (x.high - x.low) + 1e-5, dy = 1e-3 * (y.high - y.low) + 1e-5;
  return {static_cast<float>(x.low - dx), static_cast<float>(x.high + dx), static_cast<float>(y.low - dy),
          static_cast<float>(y.high + dy)};
}

/// Slopes of the two planes through the camera that touch an ellipsoid, along one axis. The plane (1, 0, -s) touches
/// the ellipsoid of middle p and matrix E = R diag(half_size^2) R^T where (n . p)^2 = n^T E n: a quadratic equation for
/// s. False when the ellipsoid reaches behind the camera's plane.
bool tangents(double p, double pz, double e, double e_z, double e_zz, Range& range) {
  const double a = pz * pz - e_zz, b = p * pz - e_z, c = p * p - e;
  if (pz <= 0.0 || a <= 1e-3 * pz * pz) return false;
  const double root = std::sqrt(std::max(b * b - a * c, 0.0));
  range.include((b - root) / a);
  range.include((b + root) / a);
  return true;
}

/// An ellipsoid of half axes along the columns given; a disc has one that is zero.
bool includeEllipsoid(const Vector3& p, const Vector3 (&axis)[3], Range& x, Range& y) {
  const auto entry = [&](int i, int j) {
    return axis[0][i] * axis[0][j] + axis[1][i] * axis[1][j] + axis[2][i] * axis[2][j];
  };
  Range along_x, along_y;
  if (!tangents(p.x, p.z, entry(0, 0), entry(0, 2), entry(2, 2), along_x)) return false;
  if (!tangents(p.y, p.z, entry(1, 1), entry(1, 2), entry(2, 2), along_y)) return false;
  x.include(along_x), y.include(along_y);
  return true;
}

/// A parallelepiped about p: its corners ahead of the camera, and where its edges pass the camera's plane.
void includeBox(const Vector3& p, const Vector3 (&axis)[3], Range& x, Range& y) {
  Vector3 corner[8];
  for (int k = 0; k < 8; ++k)
    corner[k] = p + axis[0] * (k & 1 ? 1.0 : -1.0) + axis[1] * (k & 2 ? 1.0 : -1.0) + axis[2] * (k & 4 ? 1.0 : -1.0);
  const auto include = [&](const Vector3& v) { x.include(v.x / v.z), y.include(v.y / v.z); };
  for (int k = 0; k < 8; ++k) {
    if (corner[k].z >= kNearest) include(corner[k]);
    for (const int step : {1, 2, 4}) {
      if (k & step) continue;
      const Vector3 &a = corner[k], &b = corner[k | step];
      if ((a.z < kNearest) == (b.z < kNearest)) continue;
      Vector3 cut = interpolate(a, b, (kNearest - a.z) / (b.z - a.z));
      cut.z = kNearest;
      include(cut);
    }
  }
}

}  // namespace

SlopeRectangle rectangleOf(const Shape& shape, const Pose& X_CS) {
  const Rotation3& r = X_CS.rotation;
  const Vector3& p = X_CS.translation;
  Vector3 axis[3] = {r.x * shape.half_size.x, r.y * shape.half_size.y, r.z * shape.half_size.z};
  Range x, y;
  bool found = false;
  if (shape.kind == ShapeKind::kEllipsoid) found = includeEllipsoid(p, axis, x, y);
  if (shape.kind == ShapeKind::kCylinder) {
    const Vector3 disc[3] = {axis[0], axis[1], {0, 0, 0}};
    found = includeEllipsoid(p + axis[2], disc, x, y) && includeEllipsoid(p - axis[2], disc, x, y);
  }
  if (shape.kind == ShapeKind::kCapsule) {
    const double radius = shape.half_size.x;
    const Vector3 ball[3] = {r.x * radius, r.y * radius, r.z * radius};
    found = includeEllipsoid(p + axis[2], ball, x, y) && includeEllipsoid(p - axis[2], ball, x, y);
    axis[2] = r.z * (shape.half_size.z + radius);
  }
  if (!found) x = y = {}, includeBox(p, axis, x, y);
  return widened(x, y);
}

SlopeRectangle rectangleOfEllipse(const Vector3& middle_C, const Vector3& first_C, const Vector3& second_C) {
  const Vector3 axis[3] = {first_C, second_C, {0, 0, 0}};
  Range x, y;
  if (!includeEllipsoid(middle_C, axis, x, y)) x = y = {}, includeBox(middle_C, axis, x, y);
  return widened(x, y);
}

}  // namespace murosimf
