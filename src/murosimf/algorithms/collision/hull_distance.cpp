#include "murosimf/algorithms/collision/hull_distance.h"

#include <limits>

namespace murosimf {
namespace {

Vector3 nearestOnSegment(const Vector3& p, const Vector3& begin, const Vector3& end) {
  const Vector3 along = end - begin;
  return plusScaled(begin, along, clamp(dot(p - begin, along) / squaredNorm(along), 0.0, 1.0));
}

/// The nearest point of a face, and on which of its edges it lies: numbers of both ends, or -1 inside the outline.
struct FacePoint {
  Vector3 q;
  double squared_distance = 0;
  int begin = -1, end = -1;
};

/// To a point that lies `height` above the face's plane: p's foot if that is inside the outline, else a point of an
/// edge beyond which the foot lies.
FacePoint nearestOnFace(const Vector3& p, double height, const ConvexHull& hull, const ConvexHull::Face& face) {
  const auto loop = hull.corners(face);
  FacePoint nearest{p - face.normal * height, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int from = loop[i], to = loop[i + 1 < loop.size() ? i + 1 : 0];
    const Vector3 &begin = hull.vertex(from), &end = hull.vertex(to);
    if (dot(cross(end - begin, p - begin), face.normal) >= 0) continue;
    const Vector3 q = nearestOnSegment(p, begin, end);
    const double distance = squaredNorm(p - q);
    if (distance < nearest.squared_distance) nearest = {q, distance, from, to};
  }
  if (nearest.begin < 0) nearest.squared_distance = height * height;
  return nearest;
}

/// The nearest of the faces around the ends of an edge, where one is nearer than what is known.
FacePoint nearestAround(const FacePoint& known, const Vector3& p, const ConvexHull& hull) {
  FacePoint nearest = known;
  for (const int vertex : {known.begin, known.end}) {
    for (const int number : hull.facesAround(vertex)) {
      const ConvexHull::Face& face = hull.faces()[static_cast<std::size_t>(number)];
      const double height = dot(face.normal, p) - face.offset;
      if (height <= 0 || height * height >= nearest.squared_distance) continue;
      const FacePoint found = nearestOnFace(p, height, hull, face);
      if (found.squared_distance < nearest.squared_distance) nearest = found;
    }
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
  // A body is convex, so a point that no face around it betters is the nearest of all.
  FacePoint nearest = nearestOnFace(p, height, hull, *highest);
  for (double last = std::numeric_limits<double>::infinity(); nearest.begin >= 0 && nearest.squared_distance < last;) {
    last = nearest.squared_distance;
    nearest = nearestAround(nearest, p, hull);
  }
  best.point = nearest.q;
  best.distance = sqrt(nearest.squared_distance);
  // On the surface the gap has no direction left.
  constexpr double kOnSurface = 1e-12;
  if (best.distance > kOnSurface) best.normal = (p - best.point) * (1 / best.distance);
  return best;
}

}  // namespace murosimf
