#pragma once

/// @file Where a sphere touches another shape, in closed form: depth, point and normal.
///
/// A is the sphere, B the other shape. The witness point of B is its surface point nearest to the sphere's centre c
/// (c inside B: nearest all the same, which is the shortest way out), that of A lies r below c along the normal.
///     normal   from B to A, the direction of the force on A, unit length, world axes
///     depth    r - (signed distance from B's surface to c) [m]; negative is a gap
///     point    midpoint of the two witness points [m], world
/// Where the nearest point is not unique (centre of a sphere, axis of a cylinder) one is chosen by a fixed rule.
///
/// Ellipsoid: the root of sum (a_k y_k / (t + a_k^2))^2 = 1, found by Newton's method from the left, which a convex
/// falling function turns into a monotone sequence [Eberly, Distance from a Point to an Ellipsoid, 2013]; 1e-12 of
/// size. Convex hull: collision/hull_distance.h.

#include "murosimf/algorithms/shape.h"

namespace murosimf {

class ConvexHull;

struct SphereContact {
  double depth = 0;
  Vector3 point;
  Vector3 normal{0, 0, 1};
};

/// The surface point of a shape nearest to a given point, in the shape's frame S.
struct NearestPoint {
  Vector3 point;        ///< on the surface [m]
  Vector3 normal;       ///< outward unit normal there, along which the given point lies
  double distance = 0;  ///< along the normal [m]; negative inside
};

NearestPoint nearestOnBox(const Vector3& p_S, const Vector3& half_size);
NearestPoint nearestOnCylinder(const Vector3& p_S, double radius, double half_length);
NearestPoint nearestOnCapsule(const Vector3& p_S, double radius, double half_length);
NearestPoint nearestOnEllipsoid(const Vector3& p_S, const Vector3& radii);
/// @param hull  of a kConvex shape
NearestPoint nearestOn(const Shape& shape, const Vector3& p_S, const ConvexHull* hull = nullptr);

/// B is all that lies below the plane z = 0 of S.
SphereContact sphereAgainstPlane(const Vector3& p_WC, double radius, const Pose& X_WS);
/// B is a solid shape. The contact with a hull that is more than 0.1 m away is that with a plane which separates the
/// two.
/// @param hull  of a kConvex shape
SphereContact sphereAgainstShape(const Vector3& p_WC, double radius, const Shape& shape, const Pose& X_WS,
                                 const ConvexHull* hull = nullptr);
/// B is a sphere about p_WD. Coinciding centres separate along z.
SphereContact sphereAgainstSphere(const Vector3& p_WC, double radius, const Vector3& p_WD, double other_radius);

}  // namespace murosimf
