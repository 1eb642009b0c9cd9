#pragma once

/// @file Where two shapes touch: every pair of kinds, in any order.
///
///     ContactManifold manifold;
///     detectContact(sole, X_WA, ground, X_WB, manifold);
///     for (int i = 0; i < manifold.count; ++i) ...
///
/// The pair is treated in the order of its kinds (of equal kinds: of sizes, then of places), so swapped arguments give
/// the same bits with the normal turned about. Closed forms are exact to rounding; what is iterative is exact to
/// 2e-7 m + 2e-4 depth (least_depth.h). Which pair is which, and what it costs: docs/collisions.md.
/// Deterministic; allocates nothing, throws nothing.

#include "murosimf/algorithms/collision/collision_shape.h"
#include "murosimf/algorithms/collision/contact_manifold.h"

namespace murosimf {

/// Overwrites `out`; out.count is 0 where the shapes do not touch, and always for two planes. out.apart is then a lower
/// bound of their distance, where the pair's method knows one. Sizes > 0.
/// @param last_normal  the normal of the same pair in the frame before, zero for none. Deeply overlapping boxes keep
///                     it (collision_pairs.h); elsewhere a search starts there, or is saved where it still separates
///                     the shapes; the result is the same within its accuracy. Unit length.
void detectContact(const CollisionShape& a, const Pose& X_WA, const CollisionShape& b, const Pose& X_WB,
                   ContactManifold& out, const Vector3& last_normal = {});

}  // namespace murosimf
