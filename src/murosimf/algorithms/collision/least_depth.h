#pragma once

/// @file The shortest way out for any two convex shapes, from their support points alone.
///
/// Along a unit vector n, from B to A, the shapes overlap by
///     h(n) = n.(b(n) - a(-n)),    a(d), b(d) support points,
/// so that A moved by n h(n) just touches. Wanted is the n of least h. The points s(n) = b(n) - a(-n) lie on the
/// surface of the difference B - A, and the least h is the distance of that surface from the origin. A polytope of some
/// of these points grows at its face nearest to the origin until the face is the surface [van den Bergen 2001,
/// Proximity Queries and Penetration Depth Computation on 3D Game Objects]. What is found holds over all directions,
/// not only near the start, and its depth is never less than the true one:
///     depth - true depth <= 2e-7 m + 2e-4 depth, as long as 64 points suffice; measured: 3.3e-6 m at most.
/// Points are interpolated within the last face, on a smooth surface the normal too, which makes them exact to the
/// second order of its size: 0.1 mm. Shapes that overlap by less than 1e-7 m may be called separate. Cost: 10 to 40
/// pairs of support points; no allocation.

#include "murosimf/algorithms/collision/collision_shape.h"

namespace murosimf {

/// Two shapes, none of them a plane, in A's frame.
struct ConvexPair {
  const CollisionShape& a;
  const CollisionShape& b;
  Pose X_AB;

  Vector3 supportOfA(const Vector3& d) const { return supportPoint(a, d); }
  Vector3 supportOfB(const Vector3& d) const { return X_AB * supportPoint(b, applyTransposed(X_AB.rotation, d)); }
  /// h(n).
  double depthAlong(const Vector3& n) const { return dot(n, supportOfB(n) - supportOfA(-n)); }
};

struct LeastDepth {
  double depth = 0;  ///< [m]; not positive where the shapes do not overlap
  Vector3 normal;    ///< from B to A
  Vector3 midpoint;  ///< between both surface points
};

/// `start`: a unit vector near which the normal is likely to be found.
LeastDepth leastDepth(const ConvexPair& pair, const Vector3& start);

}  // namespace murosimf
