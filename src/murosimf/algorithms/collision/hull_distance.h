#pragma once

/// @file The point of a convex hull's surface that lies nearest to a given point.

#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/sphere_contact.h"

namespace murosimf {

/// Inside: the nearest face. Outside: the nearest point of a face, an edge or a corner, found from the face whose plane
/// is farthest by going on to faces beside it that are nearer. Points farther than `reach` [m] from some face's plane
/// are answered by that plane: farther than `reach` too. Cost: 1 ns a face, and some 20 faces with their corners; 0.1
/// us at a flat face.
NearestPoint nearestOnHull(const Vector3& p_S, const ConvexHull& hull, double reach);

}  // namespace murosimf
