#pragma once

/// @file Shapes as collision detection sees them: the primitives of shape.h, and plane, capsule and convex hull.
///
/// A shape stands in its own frame S: origin at its centre (a hull's: wherever its points put it), the axis of a
/// cylinder or capsule along z. Functions say how far it reaches in a direction; they are all that the iterative
/// methods know of it.

#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/shape.h"

namespace murosimf {

/// In this order the two shapes of a pair are treated (collision_pairs.h).
enum class CollisionKind : std::uint8_t { kPlane, kSphere, kBox, kCapsule, kCylinder, kEllipsoid, kConvex };
inline constexpr int kCollisionKinds = 7;

struct CollisionShape {
  CollisionKind kind = CollisionKind::kSphere;
  /// [m] A box's half edges; an ellipsoid's radii; a sphere's radius three times; a cylinder's (radius, radius, half
  /// length); a capsule's (radius, radius, half distance of its two ends' centres).
  Vector3 half_size;
  const ConvexHull* hull = nullptr;  ///< kConvex; not owned
  friend bool operator==(const CollisionShape&, const CollisionShape&) = default;
};

/// All that lies below z = 0 of S.
inline CollisionShape collisionPlane() { return {CollisionKind::kPlane, {}, nullptr}; }
inline CollisionShape collisionSphere(double radius) {
  return {CollisionKind::kSphere, {radius, radius, radius}, nullptr};
}
inline CollisionShape collisionBox(const Vector3& edges) { return {CollisionKind::kBox, edges * 0.5, nullptr}; }
/// All that lies within `radius` of a segment of this length, from -length/2 to length/2 on z.
inline CollisionShape collisionCapsule(double radius, double length) {
  return {CollisionKind::kCapsule, {radius, radius, 0.5 * length}, nullptr};
}
inline CollisionShape collisionCylinder(double radius, double length) {
  return {CollisionKind::kCylinder, {radius, radius, 0.5 * length}, nullptr};
}
/// Equal radii make a sphere.
CollisionShape collisionEllipsoid(const Vector3& radii);
/// The hull must live as long as the shape is used.
inline CollisionShape collisionConvex(const ConvexHull& hull) { return {CollisionKind::kConvex, {}, &hull}; }
/// @param hull  of a kConvex shape; must live as long as what is returned
CollisionShape collisionShapeOf(const Shape& shape, const ConvexHull* hull = nullptr);

/// Radius of the smallest sphere about S's origin that holds the shape [m]; infinite for a plane.
double boundingRadius(const CollisionShape& shape);

/// Half of the smallest extent [m]; infinite for a plane. Of a hull: across its faces, which is exact unless it is
/// thinner between two edges. Cost there: faces times vertices.
double halfThickness(const CollisionShape& shape);

/// A point inside: S's origin, or a hull's centre.
Vector3 innerPoint(const CollisionShape& shape);

/// A point of the shape that lies farthest in direction d (of any length > 0). Not for planes.
Vector3 supportPoint(const CollisionShape& shape, const Vector3& d_S);

}  // namespace murosimf
