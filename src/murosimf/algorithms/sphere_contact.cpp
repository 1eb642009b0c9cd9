#include "murosimf/algorithms/sphere_contact.h"

#include <limits>

#include "murosimf/algorithms/collision/hull_distance.h"

namespace murosimf {
namespace {

constexpr double kFar = 0.1;  // [m] of gap beyond which nobody asks for a hull's nearest point

double signOf(double x) { return x < 0 ? -1.0 : 1.0; }

NearestPoint outside(const Vector3& p_S, const Vector3& nearest) {
  const Vector3 gap = p_S - nearest;
  const double distance = norm(gap);
  return {nearest, gap * (1 / distance), distance};
}

NearestPoint nearestOnSphere(const Vector3& p_S, double radius) {
  const double size = norm(p_S);
  const Vector3 normal = size > 0 ? p_S * (1 / size) : Vector3{0, 0, 1};
  return {normal * radius, normal, size - radius};
}

/// The ellipsoid's equation in units of its shortest radius a_0: v = 1 + t/a_0^2, terms w_k = r_k z_k/(v + r_k - 1)
/// with r_k = (a_k/a_0)^2 >= 1, z_k = |y_k|/a_k. At the wanted v > 0 the w_k are the unit vector of the surface point.
/// v, not t, is the unknown because near the long axes t -> -a_0^2 and v keeps its digits there.
struct EllipsoidEquation {
  Vector3 r, z;

  double term(int k, double v) const { return z[k] > 0 ? r[k] * z[k] / (v + (r[k] - 1)) : 0.0; }

  /// Every term alone equals 1 at r_k z_k - (r_k - 1), so the sum exceeds 1 left of the largest of these: a start from
  /// which Newton's method rises to the root without passing it.
  double lowerBound() const {
    double v = 0;
    for (int k = 0; k < 3; ++k) v = max(v, r[k] * z[k] - (r[k] - 1));
    return v;
  }

  /// Root v >= 0; 0 where the sum stays below 1 (points on the plane of the long axes near the centre).
  double solve() const {
    double low = lowerBound(), high = low + norm(Vector3{r.x * z.x, r.y * z.y, r.z * z.z});
    double v = low;
    for (int i = 0; i < 60; ++i) {
      double sum = -1, slope = 0;
      for (int k = 0; k < 3; ++k) {
        const double w = term(k, v);
        sum += w * w;
        if (w > 0) slope -= 2 * w * w / (v + (r[k] - 1));
      }
      if (sum <= 0 && i == 0) return v;
      (sum > 0 ? low : high) = v;
      double next = v - sum / slope;
      if (!(next >= low && next <= high)) next = 0.5 * (low + high);
      if (next == v || abs(next - v) <= 1e-16 * next) break;
      v = next;
    }
    return v;
  }
};

}  // namespace

NearestPoint nearestOnBox(const Vector3& p_S, const Vector3& half_size) {
  const Vector3 clamped{clamp(p_S.x, -half_size.x, half_size.x), clamp(p_S.y, -half_size.y, half_size.y),
                        clamp(p_S.z, -half_size.z, half_size.z)};
  if (!(clamped == p_S)) return outside(p_S, clamped);
  int axis = 0;
  double distance = abs(p_S.x) - half_size.x;
  for (int k = 1; k < 3; ++k) {
    const double d = abs(p_S[k]) - half_size[k];
    if (d > distance) distance = d, axis = k;
  }
  NearestPoint result{p_S, {}, distance};
  result.normal[axis] = signOf(p_S[axis]);
  result.point[axis] = result.normal[axis] * half_size[axis];
  return result;
}

NearestPoint nearestOnCylinder(const Vector3& p_S, double radius, double half_length) {
  const double off_axis = sqrt(p_S.x * p_S.x + p_S.y * p_S.y);
  const Vector3 outward = off_axis > 0 ? Vector3{p_S.x / off_axis, p_S.y / off_axis, 0} : Vector3{1, 0, 0};
  if (off_axis > radius || abs(p_S.z) > half_length) {
    const double z = clamp(p_S.z, -half_length, half_length);
    if (off_axis <= radius) return {{p_S.x, p_S.y, z}, {0, 0, signOf(p_S.z)}, abs(p_S.z) - half_length};
    if (z == p_S.z) return {outward * radius + Vector3{0, 0, z}, outward, off_axis - radius};
    return outside(p_S, outward * radius + Vector3{0, 0, z});
  }
  const double to_side = off_axis - radius, to_disc = abs(p_S.z) - half_length;
  if (to_side >= to_disc) return {outward * radius + Vector3{0, 0, p_S.z}, outward, to_side};
  const double sign = signOf(p_S.z);
  return {{p_S.x, p_S.y, sign * half_length}, {0, 0, sign}, to_disc};
}

NearestPoint nearestOnCapsule(const Vector3& p_S, double radius, double half_length) {
  const Vector3 on_axis{0, 0, clamp(p_S.z, -half_length, half_length)}, gap = p_S - on_axis;
  const double size = norm(gap);
  const Vector3 normal = size > 0 ? gap * (1 / size) : Vector3{1, 0, 0};
  return {on_axis + normal * radius, normal, size - radius};
}

NearestPoint nearestOnEllipsoid(const Vector3& p_S, const Vector3& radii) {
  if (radii.x == radii.y && radii.y == radii.z) return nearestOnSphere(p_S, radii.x);
  int shortest = radii.y < radii.x ? 1 : 0;
  if (radii.z < radii[shortest]) shortest = 2;
  EllipsoidEquation equation;
  for (int k = 0; k < 3; ++k) {
    const double ratio = radii[k] / radii[shortest];
    equation.r[k] = ratio * ratio;
    equation.z[k] = abs(p_S[k]) / radii[k];
  }
  const double v = equation.solve();
  Vector3 w;
  for (int k = 0; k < 3; ++k) w[k] = signOf(p_S[k]) * equation.term(k, v);
  // What the other axes leave over belongs to the shortest one: nothing at a root, the whole height where v = 0.
  const double missing = 1 - squaredNorm(w);
  if (v == 0 && missing > 0) w[shortest] = signOf(p_S[shortest]) * sqrt(missing);
  w = normalized(w);
  const Vector3 point{w.x * radii.x, w.y * radii.y, w.z * radii.z};
  const Vector3 normal = normalized(Vector3{w.x / radii.x, w.y / radii.y, w.z / radii.z});
  return {point, normal, dot(p_S - point, normal)};
}

namespace {

/// @param reach  as of nearestOnHull()
NearestPoint nearestWithin(double reach, const Shape& shape, const Vector3& p_S, const ConvexHull* hull) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return nearestOnBox(p_S, shape.half_size);
    case ShapeKind::kCylinder:
      return nearestOnCylinder(p_S, shape.half_size.x, shape.half_size.z);
    case ShapeKind::kCapsule:
      return nearestOnCapsule(p_S, shape.half_size.x, shape.half_size.z);
    case ShapeKind::kConvex:
      return nearestOnHull(p_S, *hull, reach);
    case ShapeKind::kEllipsoid:
      break;
  }
  return nearestOnEllipsoid(p_S, shape.half_size);
}

}  // namespace

NearestPoint nearestOn(const Shape& shape, const Vector3& p_S, const ConvexHull* hull) {
  return nearestWithin(std::numeric_limits<double>::infinity(), shape, p_S, hull);
}

SphereContact sphereAgainstPlane(const Vector3& p_WC, double radius, const Pose& X_WS) {
  const Vector3 normal = X_WS.rotation.z;
  const double height = dot(normal, p_WC - X_WS.translation);
  return {radius - height, p_WC - normal * (0.5 * (radius + height)), normal};
}

SphereContact sphereAgainstShape(const Vector3& p_WC, double radius, const Shape& shape, const Pose& X_WS,
                                 const ConvexHull* hull) {
  const NearestPoint nearest = nearestWithin(radius + kFar, shape, applyInverse(X_WS, p_WC), hull);
  const Vector3 normal = X_WS.rotation * nearest.normal;
  return {radius - nearest.distance, p_WC - normal * (0.5 * (radius + nearest.distance)), normal};
}

SphereContact sphereAgainstSphere(const Vector3& p_WC, double radius, const Vector3& p_WD, double other_radius) {
  const NearestPoint nearest = nearestOnSphere(p_WC - p_WD, other_radius);
  return {radius - nearest.distance, p_WC - nearest.normal * (0.5 * (radius + nearest.distance)), nearest.normal};
}

}  // namespace murosimf
