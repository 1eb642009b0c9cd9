#pragma once

/// @file A second ray caster to judge the first: double precision, one ray after the other through every drawable,
/// textbook formulas in distances, no tiles, no order, no paint.

#include <cmath>
#include <limits>

#include "murosimf/algorithms/ray_scene.h"

namespace murosimf::camera_reference {

struct Hit {
  double depth = std::numeric_limits<double>::infinity();
  int label = kSkyLabel;
  Vector3 normal_W;
};

/// Where o + t d enters a shape in its own frame; t < 0 when it does not. Also the outward normal there.
inline double enterBox(const Vector3& half, const Vector3& o, const Vector3& d, Vector3& normal) {
  double entry = -1e300, exit = 1e300;
  for (int i = 0; i < 3; ++i) {
    double low = (-half[i] - o[i]) / d[i], high = (half[i] - o[i]) / d[i];
    if (low > high) std::swap(low, high);
    if (low > entry) entry = low, normal = {}, normal[i] = d[i] > 0 ? -1 : 1;
    exit = std::min(exit, high);
  }
  return entry <= exit ? entry : -1;
}
inline double enterEllipsoid(const Vector3& half, const Vector3& o, const Vector3& d, Vector3& normal) {
  const Vector3 p{o.x / half.x, o.y / half.y, o.z / half.z}, e{d.x / half.x, d.y / half.y, d.z / half.z};
  const double a = dot(e, e), b = dot(p, e), c = dot(p, p) - 1, root = b * b - a * c;
  if (root < 0) return -1;
  const double t = (-b - std::sqrt(root)) / a;
  const Vector3 q = p + e * t;
  normal = normalized(Vector3{q.x / half.x, q.y / half.y, q.z / half.z});
  return t;
}
inline double enterCylinder(const Vector3& half, const Vector3& o, const Vector3& d, Vector3& normal) {
  double best = -1;
  const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, c = o.x * o.x + o.y * o.y - half.x * half.x;
  const double root = b * b - a * c;
  if (root >= 0 && c > 0) {
    const double t = (-b - std::sqrt(root)) / a;
    if (t > 0 && std::fabs(o.z + t * d.z) <= half.z)
      best = t, normal = normalized(Vector3{o.x + t * d.x, o.y + t * d.y, 0});
  }
  if (std::fabs(o.z) > half.z) {
    const double side = o.z > 0 ? 1 : -1, t = (side * half.z - o.z) / d.z;
    const double x = o.x + t * d.x, y = o.y + t * d.y;
    if (t > 0 && x * x + y * y <= half.x * half.x && (best < 0 || t < best)) best = t, normal = {0, 0, side};
  }
  return best;
}

inline bool holds(const Drawable& drawable, const Vector3& eye_W) {
  const Vector3 p = applyInverse(drawable.X_WS, eye_W), &h = drawable.shape.half_size;
  const Vector3 u{p.x / h.x, p.y / h.y, p.z / h.z};
  if (drawable.shape.kind == ShapeKind::kBox) return std::max({std::fabs(u.x), std::fabs(u.y), std::fabs(u.z)}) <= 1;
  if (drawable.shape.kind == ShapeKind::kEllipsoid) return dot(u, u) <= 1;
  return u.x * u.x + u.y * u.y <= 1 && std::fabs(u.z) <= 1;
}

/// What the ray (x, y, 1) of a camera sees first. Its depth is t, since the ray's z component is 1.
inline Hit cast(const RayScene& scene, const Pose& X_WC, double x, double y) {
  const Vector3 d_W = X_WC.rotation * Vector3{x, y, 1}, &eye = X_WC.translation;
  Hit hit;
  if (d_W.z < 0) hit = {-eye.z / d_W.z, kGroundLabel, {0, 0, 1}};
  for (const Drawable& drawable : scene.drawables) {
    if (holds(drawable, eye)) continue;
    const Vector3 o = applyInverse(drawable.X_WS, eye), d = applyTransposed(drawable.X_WS.rotation, d_W);
    const Vector3& half = drawable.shape.half_size;
    Vector3 normal;
    const double t = drawable.shape.kind == ShapeKind::kBox         ? enterBox(half, o, d, normal)
                     : drawable.shape.kind == ShapeKind::kEllipsoid ? enterEllipsoid(half, o, d, normal)
                                                                    : enterCylinder(half, o, d, normal);
    if (t > 0 && t < hit.depth) hit = {t, drawable.label, drawable.X_WS.rotation * normal};
  }
  return hit;
}

}  // namespace murosimf::camera_reference
