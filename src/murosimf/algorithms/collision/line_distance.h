#pragma once

/// @file Where two straight lines come nearest.

#include "murosimf/math/vec3.h"

namespace murosimf {

/// Midpoint between the nearest points of the lines through p and q with unit directions u and w, not parallel.
inline Vector3 midpointOfLines(const Vector3& p, const Vector3& u, const Vector3& q, const Vector3& w) {
  const Vector3 gap = q - p, across = cross(u, w);
  const double per_square = 1 / squaredNorm(across);
  const double s = dot(cross(gap, w), across) * per_square, t = dot(cross(gap, u), across) * per_square;
  return (plusScaled(p, u, s) + plusScaled(q, w, t)) * 0.5;
}

}  // namespace murosimf
