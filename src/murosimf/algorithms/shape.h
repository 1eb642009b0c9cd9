#pragma once

/// @file Shapes of bodies, used alike by contacts, cameras and pictures.
///
/// A shape stands in its own frame S: origin at its centre, the axis of a cylinder or capsule along z. Its place on a
/// body B is a constant X_BS kept beside it, and so are the vertices of a convex hull (collision/hull_shape.h). Cameras
/// draw all but hulls, which they draw as meshes (triangle_mesh.h).

#include <cstdint>

#include "murosimf/math/transform.h"

namespace murosimf {

enum class ShapeKind : std::uint8_t { kBox, kEllipsoid, kCylinder, kCapsule, kConvex };

/// half_size [m]: a box's half edges; an ellipsoid's radii; a cylinder's (radius, radius, half length); a capsule's
/// (radius, radius, half distance of its two ends' centres); a convex hull's half edges of its bounding box, at whose
/// centre S then stands.
struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  Vector3 half_size;
  friend bool operator==(const Shape&, const Shape&) = default;
};

inline Shape makeBox(const Vector3& edges) { return {ShapeKind::kBox, edges * 0.5}; }
inline Shape makeSphere(double radius) { return {ShapeKind::kEllipsoid, {radius, radius, radius}}; }
inline Shape makeEllipsoid(const Vector3& radii) { return {ShapeKind::kEllipsoid, radii}; }
inline Shape makeCylinder(double radius, double length) {
  return {ShapeKind::kCylinder, {radius, radius, 0.5 * length}};
}
/// All that lies within `radius` of a segment of this length.
inline Shape makeCapsule(double radius, double length) { return {ShapeKind::kCapsule, {radius, radius, 0.5 * length}}; }

/// Radius of the smallest sphere about the shape's centre that holds it; of a convex hull, that holds its bounding box
/// [m].
inline double boundingRadius(const Shape& s) {
  if (s.kind == ShapeKind::kEllipsoid) return max(s.half_size.x, max(s.half_size.y, s.half_size.z));
  if (s.kind == ShapeKind::kCylinder) return sqrt(s.half_size.x * s.half_size.x + s.half_size.z * s.half_size.z);
  if (s.kind == ShapeKind::kCapsule) return s.half_size.x + s.half_size.z;
  return norm(s.half_size);
}

/// Linear colour components in [0, 1].
struct Colour {
  float red = 0.5F, green = 0.5F, blue = 0.5F;
  friend bool operator==(const Colour&, const Colour&) = default;
};

}  // namespace murosimf
