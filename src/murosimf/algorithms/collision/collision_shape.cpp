#include "murosimf/algorithms/collision/collision_shape.h"

#include <limits>

namespace murosimf {
namespace {

double withSignOf(double size, double direction) { return direction < 0 ? -size : size; }

Vector3 supportOfCylinder(const Vector3& a, const Vector3& d) {
  const double off_axis = sqrt(d.x * d.x + d.y * d.y);
  const double scale = off_axis > 0 ? a.x / off_axis : 0.0;
  return {d.x * scale, d.y * scale, withSignOf(a.z, d.z)};
}

Vector3 supportOfEllipsoid(const Vector3& a, const Vector3& d) {
  const Vector3 scaled{a.x * d.x, a.y * d.y, a.z * d.z};
  const double factor = 1 / norm(scaled);
  return {a.x * scaled.x * factor, a.y * scaled.y * factor, a.z * scaled.z * factor};
}

}  // namespace

CollisionShape collisionEllipsoid(const Vector3& radii) {
  const bool round = radii.x == radii.y && radii.y == radii.z;
  return {round ? CollisionKind::kSphere : CollisionKind::kEllipsoid, radii, nullptr};
}

CollisionShape collisionShapeOf(const Shape& shape, const ConvexHull* hull) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return {CollisionKind::kBox, shape.half_size, nullptr};
    case ShapeKind::kCylinder:
      return {CollisionKind::kCylinder, shape.half_size, nullptr};
    case ShapeKind::kCapsule:
      return {CollisionKind::kCapsule, shape.half_size, nullptr};
    case ShapeKind::kConvex:
      return collisionConvex(*hull);
    case ShapeKind::kEllipsoid:
      break;
  }
  return collisionEllipsoid(shape.half_size);
}

double boundingRadius(const CollisionShape& shape) {
  const Vector3& a = shape.half_size;
  switch (shape.kind) {
    case CollisionKind::kPlane:
      return std::numeric_limits<double>::infinity();
    case CollisionKind::kBox:
      return norm(a);
    case CollisionKind::kCapsule:
      return a.x + a.z;
    case CollisionKind::kCylinder:
      return sqrt(a.x * a.x + a.z * a.z);
    case CollisionKind::kConvex:
      return shape.hull->boundingRadius();
    case CollisionKind::kSphere:
    case CollisionKind::kEllipsoid:
      break;
  }
  return max(a.x, max(a.y, a.z));
}

double halfThickness(const CollisionShape& shape) {
  const Vector3& a = shape.half_size;
  if (shape.kind == CollisionKind::kPlane) return std::numeric_limits<double>::infinity();
  if (shape.kind == CollisionKind::kCapsule) return a.x;
  if (shape.kind != CollisionKind::kConvex) return min(a.x, min(a.y, a.z));
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexHull::Face& face : shape.hull->faces()) {
    double width = 0;
    for (const Vector3& p : shape.hull->vertices()) width = max(width, face.offset - dot(face.normal, p));
    least = min(least, width);
  }
  return 0.5 * least;
}

Vector3 innerPoint(const CollisionShape& shape) {
  return shape.kind == CollisionKind::kConvex ? shape.hull->centre() : Vector3{};
}

Vector3 supportPoint(const CollisionShape& shape, const Vector3& d) {
  const Vector3& a = shape.half_size;
  switch (shape.kind) {
    case CollisionKind::kBox:
      return {withSignOf(a.x, d.x), withSignOf(a.y, d.y), withSignOf(a.z, d.z)};
    case CollisionKind::kCylinder:
      return supportOfCylinder(a, d);
    case CollisionKind::kCapsule:
      return d * (a.x / norm(d)) + Vector3{0, 0, withSignOf(a.z, d.z)};
    case CollisionKind::kConvex:
      return shape.hull->vertex(shape.hull->farthestVertex(d));
    case CollisionKind::kPlane:
    case CollisionKind::kSphere:
    case CollisionKind::kEllipsoid:
      break;
  }
  return supportOfEllipsoid(a, d);
}

}  // namespace murosimf
