#include "murosimf/algorithms/collision/hull_distance.h"

#include <limits>

namespace murosimf {
namespace {

Vector3 nearestOnSegment(const Vector3& p, const Vector3& begin, const Vector3& end) {
  const Vector3 along = end - begin;
  return plusScaled(begin, along, clamp(dot(p - begin, along) / squaredNorm(along), 0.0, 1.0));
}

/// Nearest point of a face to a point that lies `height` above its plane: p's foot if that is inside the outline, else
/// a point of an edge beyond which the foot lies.
Vector3 nearestOnFace(const Vector3& p, double height, const ConvexHull& hull, const ConvexHull::Face& face) {
  const auto loop = hull.corners(face);
  Vector3 nearest = p - face.normal * height;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector3 &begin = hull.vertex(loop[i]), &end = hull.vertex(loop[i + 1 < loop.size() ? i + 1 : 0]);
    if (dot(cross(end - begin, p - begin), face.normal) >= 0) continue;
    const Vector3 q = nearestOnSegment(p, begin, end);
    const double distance = squaredNorm(p - q);
    if (distance < least) least = distance, nearest = q;
  }
  return nearest;
}

}  // namespace

NearestPoint nearestOnHull(const Vector3& p, const ConvexHull& hull, double reach) {
  const ConvexHull::Face* highest = nullptr;
  double height = -std::numeric_limits<double>::infinity();
  for (const ConvexHull::Face& face : hull.faces()) {
    const double h = dot(face.normal, p) - face.offset;
    if (h > height) height = h, highest = &face;
    if (h >= reach) break;
  }
  NearestPoint best{p - highest->normal * height, highest->normal, height};
  if (height <= 0 || height >= reach) return best;
  // The face whose plane is farthest is often the nearest face; then all others are farther than its point.
  best.point = nearestOnFace(p, height, hull, *highest);
  double least = squaredNorm(p - best.point);
  for (const ConvexHull::Face& face : hull.faces()) {
    const double h = dot(face.normal, p) - face.offset;
    if (h <= 0 || h * h >= least || &face == highest) continue;
    const Vector3 q = nearestOnFace(p, h, hull, face);
    const double distance = squaredNorm(p - q);
    if (distance < least) least = distance, best.point = q;
  }
  // On the surface the gap has no direction left.
  constexpr double kOnSurface = 1e-12;
  best.distance = sqrt(least);
  if (best.distance > kOnSurface) best.normal = (p - best.point) * (1 / best.distance);
  return best;
}

}  // namespace murosimf
