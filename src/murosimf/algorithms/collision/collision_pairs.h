#pragma once

/// @file Detection for each pair of kinds, in the frame of the first shape.
///
/// Each function takes the shapes in the order of their kinds and X_AB, the pose of B's frame in A's, and fills a
/// manifold with positions and normal (from B to A) in A's frame; out.count is 0 where the shapes do not touch.
/// Closed forms; R and r are half sizes and radii, d the depth, c the centre of B.
///     plane      d = -min z over B
///     sphere     d = r - (signed distance of its centre to the other shape), sphere_contact.h
///     capsule    as a sphere about the point of its segment that lies nearest to the other shape
///     box, box   d = min over the 6 face normals and 9 products of edges of (sum of half extents - distance of
///     centres)
///                [Gottschalk, Lin, Manocha 1996]
/// Every other pair: least_depth.h.

#include "murosimf/algorithms/collision/collision_shape.h"
#include "murosimf/algorithms/collision/contact_manifold.h"

namespace murosimf {

void planeAgainstSphere(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void planeAgainstBox(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void planeAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
/// Lying: both ends of the lowest line. Standing or tilted: points of the lower rim, fixed to the body but for the
/// lowest of all.
void planeAgainstCylinder(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void planeAgainstEllipsoid(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void planeAgainstConvex(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);

void sphereAgainstSphere(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void sphereAgainstBox(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void sphereAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void sphereAgainstCylinder(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void sphereAgainstEllipsoid(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void sphereAgainstConvex(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);

/// Two points, or three, where the axes are parallel within 0.6 degrees.
void capsuleAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);
void boxAgainstCapsule(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, ContactManifold& out);

/// `hint`: the normal of the frame before, from B to A in A's frame; zero for none. While the boxes overlap by more
/// than half the thinner one's half edge, the axis nearest to it is kept, so that a thin box leaves by the side where
/// it came in.
void boxAgainstBox(const CollisionShape& a, const CollisionShape& b, const Pose& X_AB, const Vector3& hint,
                   ContactManifold& out);

}  // namespace murosimf
