#pragma once

/// @file A convex hull as the shape of a body.

#include <memory>
#include <span>

#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/shape.h"

namespace murosimf {

/// The shape's frame S stands at the centre of the bounding box of the points, parallel to the frame L in which they
/// are given.
struct HullShape {
  Shape shape;                             ///< kConvex
  Vector3 p_LS;                            ///< [m]
  std::shared_ptr<const ConvexHull> hull;  ///< in S
};

/// @throws std::invalid_argument as ConvexHull does
HullShape makeConvex(std::span<const Vector3> points_L);

}  // namespace murosimf
