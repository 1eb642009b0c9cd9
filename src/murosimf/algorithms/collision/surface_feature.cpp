#include "murosimf/algorithms/collision/surface_feature.h"

#include "murosimf/algorithms/collision/round_rim.h"

namespace murosimf {
namespace {

constexpr double kSine = 0.0523, kCosine = 0.99863;  // of 3 degrees

void faceOfBox(const Vector3& a, int axis, bool negative, SurfaceFeature& out) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  out.count = 4;
  out.name = static_cast<std::uint32_t>(2 * axis + (negative ? 1 : 0));
  out.normal = {};
  out.normal[axis] = negative ? -1 : 1;
  for (int i = 0; i < 4; ++i) {
    const bool low_j = i == 1 || i == 2, low_k = i >= 2;
    Vector3& p = out.points[negative ? 3 - i : i];
    p[axis] = out.normal[axis] * a[axis];
    p[j] = low_j ? -a[j] : a[j];
    p[k] = low_k ? -a[k] : a[k];
  }
}

int mainAxis(const Vector3& d) {
  int axis = abs(d.y) > abs(d.x) ? 1 : 0;
  if (abs(d.z) > abs(d[axis])) axis = 2;
  return axis;
}

void featureOfBox(const Vector3& a, const Vector3& d, SurfaceFeature& out) {
  const int axis = mainAxis(d);
  if (abs(d[axis]) > kCosine) return faceOfBox(a, axis, d[axis] < 0, out);
  for (int k = 0; k < 3; ++k) {
    if (abs(d[k]) > kSine) continue;
    for (int end = 0; end < 2; ++end) {
      for (int m = 0; m < 3; ++m) out.points[end][m] = d[m] < 0 ? -a[m] : a[m];
      out.points[end][k] = end == 0 ? -a[k] : a[k];
    }
    out.count = 2;
    out.name = static_cast<std::uint32_t>(6 + k);
    return;
  }
}

void featureOfCylinder(const Vector3& a, const Vector3& d, SurfaceFeature& out) {
  const double off_axis = sqrt(d.x * d.x + d.y * d.y), per_off_axis = off_axis > 0 ? 1 / off_axis : 0.0;
  if (abs(d.z) > kCosine) {
    const bool negative = d.z < 0;
    Vector3 rim[kRimPoints];
    placeOnRim(d.x * per_off_axis, d.y * per_off_axis, rim);
    out.count = kRimPoints;
    out.name = negative ? 1 : 0;
    out.normal = {0, 0, negative ? -1.0 : 1.0};
    for (int i = 0; i < kRimPoints; ++i)
      out.points[i] = rim[negative ? kRimPoints - 1 - i : i] * a.x + out.normal * a.z;
  } else if (abs(d.z) < kSine) {
    const Vector3 side{d.x * per_off_axis * a.x, d.y * per_off_axis * a.x, 0};
    out.count = 2;
    out.name = 2;
    out.points[0] = side - Vector3{0, 0, a.z};
    out.points[1] = side + Vector3{0, 0, a.z};
  }
}

void featureOfCapsule(const Vector3& a, const Vector3& d, SurfaceFeature& out) {
  if (abs(d.z) > kSine) return;
  out.count = 2;
  out.points[0] = d * a.x - Vector3{0, 0, a.z};
  out.points[1] = d * a.x + Vector3{0, 0, a.z};
}

void faceOfHull(const ConvexHull& hull, int number, SurfaceFeature& out) {
  const ConvexHull::Face& face = hull.faces()[static_cast<std::size_t>(number)];
  const auto loop = hull.corners(face);
  const int stride = (face.count + SurfaceFeature::kMost - 1) / SurfaceFeature::kMost;
  out.normal = face.normal;
  out.name = static_cast<std::uint32_t>(number);
  for (int i = 0; i < face.count; i += stride) out.points[out.count++] = hull.vertex(loop[static_cast<std::size_t>(i)]);
}

void featureOfHull(const ConvexHull& hull, const Vector3& d, SurfaceFeature& out) {
  int best = -1;
  double most = kCosine;
  for (int i = 0; i < static_cast<int>(hull.faces().size()); ++i) {
    const double along = dot(hull.faces()[static_cast<std::size_t>(i)].normal, d);
    if (along > most) most = along, best = i;
  }
  if (best >= 0) return faceOfHull(hull, best, out);
  const int tip = hull.farthestVertex(d);
  double least = kSine;
  for (const int next : hull.neighbours(tip)) {
    const Vector3 edge = hull.vertex(next) - hull.vertex(tip);
    const double slope = abs(dot(edge, d)) / norm(edge);
    if (slope >= least) continue;
    least = slope;
    out.count = 2;
    out.points[0] = hull.vertex(tip < next ? tip : next);
    out.points[1] = hull.vertex(tip < next ? next : tip);
    out.name = static_cast<std::uint32_t>(128 + (tip < next ? tip : next));
  }
}

}  // namespace

void facingFeature(const CollisionShape& shape, const Vector3& d, SurfaceFeature& out) {
  out.count = 0;
  out.name = 0;
  switch (shape.kind) {
    case CollisionKind::kBox:
      return featureOfBox(shape.half_size, d, out);
    case CollisionKind::kCylinder:
      return featureOfCylinder(shape.half_size, d, out);
    case CollisionKind::kCapsule:
      return featureOfCapsule(shape.half_size, d, out);
    case CollisionKind::kConvex:
      return featureOfHull(*shape.hull, d, out);
    case CollisionKind::kPlane:
    case CollisionKind::kSphere:
    case CollisionKind::kEllipsoid:
      break;
  }
}

void facingFaceOfBox(const Vector3& half_size, const Vector3& d, SurfaceFeature& out) {
  const int axis = mainAxis(d);
  faceOfBox(half_size, axis, d[axis] < 0, out);
}

void transformFeature(const Pose& X_AB, SurfaceFeature& feature) {
  for (int i = 0; i < feature.count; ++i) feature.points[i] = X_AB * feature.points[i];
  feature.normal = X_AB.rotation * feature.normal;
}

}  // namespace murosimf
