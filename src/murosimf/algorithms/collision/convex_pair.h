#pragma once

/// @file Pairs without a closed form, in the frame of the first shape as in collision_pairs.h.
///
/// Overlap by portals (mpr_contact.h), least depth over all directions (least_depth.h), then the points between flat or
/// straight parts that face each other (surface_feature.h).

#include "murosimf/algorithms/collision/collision_shape.h"
#include "murosimf/algorithms/collision/contact_manifold.h"

namespace murosimf {

/// `hint`: the normal of the frame before, from B to A in A's frame, zero for none; saves the search where it separates
/// the shapes.
void convexAgainstConvex(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, const Vector3& hint,
                         ContactManifold& out);

}  // namespace murosimf
