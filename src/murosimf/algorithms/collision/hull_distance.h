#pragma once

/// @file The point of a convex hull's surface that lies nearest to a given point.

#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/sphere_contact.h"

namespace murosimf {

/// Inside: the nearest face. Outside: the nearest point of all faces that the point can see, a face, an edge or a
/// corner. Points farther than `reach` [m] from some face's plane are answered by that plane: farther than `reach` too.
/// Cost O(faces + corners of the faces that are seen and may be nearer than the one farthest seen from above).
NearestPoint nearestOnHull(const Vector3& p_S, const ConvexHull& hull, double reach);

}  // namespace murosimf
